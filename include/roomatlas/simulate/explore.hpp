// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>

#include "roomatlas/simulate/simulate.hpp"

namespace roomatlas {

struct ExploreOptions {
  std::optional<Pose2> world_from_start;  ///< nothing: `default_start`
  double max_time_s = 21600.0;            ///< of the mission; the drive ends then, finished or not
  bool on_odometry = false;               ///< the explorer believes its odometry; else its pose is
                                          ///< true, as if it were perfectly localized
};

/// What an exploration came to. `finished` is false where the time ran out.
struct ExploreSummary {
  bool finished = false;
  double duration_s = 0.0;  ///< of the mission
  double path_length_m = 0.0;
  int collisions = 0;               ///< contacts with an obstacle; the robot stops at it
  std::set<RoomId> entered;         ///< rooms of the world in which the robot's middle has been
  std::int64_t rooms_found = 0;     ///< spaces between doorways that the explorer told apart
  std::int64_t doorways_found = 0;  ///< some may be gaps between furniture
  std::int64_t goals_given_up = 0;  ///< places that it could not reach
};

/// The robot drives itself, by what it has sensed and nothing else: frontiers of its own HIMM grid
/// (Yamauchi 1997) one room at a time, then the room's doorways depth first, back-tracking through
/// the graph of rooms; steering by the polar histogram (paper II.A, equations (1) to (3)).
/// It ends when nothing is left or the time is up, always.
/// @throws InputError when the start is not finite or touches an obstacle, or the world has no room
///   to start in
[[nodiscard]] ExploreSummary explore(const FloorPlan& world, const SimulationOptions& simulation,
                                     const ExploreOptions& options,
                                     const std::function<void(const SimulatedStep&)>& sink);

/// A place to start, looking along x: the label point of the first room where the robot can turn,
/// else the middle of such a free region, else what is farthest from all obstacles in the first
/// of both that has such a place.
/// @throws InputError where there is none
[[nodiscard]] Pose2 default_start(const FloorPlan& world, const RobotFootprint& footprint);

}  // namespace roomatlas
