// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

/// Which kind of building is made.
enum class RandomWorldKind {
  offices,        ///< a corridor with rooms on both sides
  long_corridor,  ///< corridors around corners, rooms on their outer side
  ring,           ///< a corridor around a core, rooms in it and around it
  equal_rooms,    ///< a corridor with rooms that nothing tells apart
  hall,           ///< a hall with side rooms
  open_plan,      ///< a large room with partitions and columns, few rooms beside it
  apartment,      ///< a rectangle that is split again and again
  wings,          ///< wings that meet at an odd angle
  rotunda,        ///< a round hall with rooms around, perhaps a wing
};
constexpr int kRandomWorldKinds = 9;  ///< how many there are

[[nodiscard]] const char* to_string(RandomWorldKind kind);

struct RandomWorldOptions {
  std::uint64_t seed = 1;               ///< decides everything
  std::optional<RandomWorldKind> kind;  ///< nothing: the seed chooses
  int rooms = 0;  ///< about so many, 3 to 40; 0: the seed chooses, mostly 5 to 20
};

/// The kind that the options choose.
[[nodiscard]] RandomWorldKind kind_of(const RandomWorldOptions& options);

/// A building that a robot can be simulated in: rooms, doors, and wall bodies of one thickness
/// (0.08 to 0.4 m) around all. Doors are 0.75 to 1.6 m wide, no room is narrower than 1.5 m, and
/// every room is joined to every other by doors. Half of the buildings stand at any angle to the
/// axes. The same options give the same plan.
/// @throws UsageError when `rooms` is neither 0 nor in [3, 40]
[[nodiscard]] FloorPlan random_world(const RandomWorldOptions& options);

}  // namespace roomatlas
