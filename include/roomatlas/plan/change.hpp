// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/core/pose2.hpp"
#include "roomatlas/plan/ids.hpp"

namespace roomatlas {

/// What became of something between two visits of a building.
enum class ChangeKind {
  door_shut,
  door_opened,
  door_turned,  ///< its leaf stands otherwise; open before and after, as far as was seen
  furniture_gone,
  furniture_new,
  furniture_moved,
  wall_gone,
  wall_new,
  wall_moved,
};
constexpr int kChangeKinds = 9;  ///< how many there are

/// "door shut", "furniture gone" ...
[[nodiscard]] const char* to_string(ChangeKind kind);

/// What one mission's readings say of a change.
struct Sighting {
  int stood = 0;              ///< readings that hit what stands in one of the missions alone
  int passed = 0;             ///< readings that saw through where the other mission has something
  std::vector<AsrId> visits;  ///< whose readings these are, ascending
  double first_s = 0.0;       ///< of these readings, in the mission's times
  double last_s = 0.0;        ///< the same

  [[nodiscard]] int readings() const { return stood + passed; }
};

/// One alteration. Both missions have seen it: what stands now stood where the old mission saw
/// through, and what is gone was hit then and is seen through now.
struct Change {
  std::int64_t id = 0;  ///< 1, 2, 3 ..., as the drawing numbers them
  ChangeKind kind = ChangeKind::furniture_gone;
  std::vector<Polygon> gone;         ///< old building's metres; empty where nothing is gone
  std::vector<Polygon> appeared;     ///< the same of what is new
  Point2 at = Point2::Zero();        ///< the middle of what stands now, or else stood
  std::optional<RoomId> room;        ///< of the old plan; none where it lies in no room
  std::string room_name;             ///< empty without a room
  std::optional<std::int64_t> door;  ///< of the old plan, of a change of a door that it has
  double size_m = 0.0;               ///< the longer side of it
  Sighting before;                   ///< by the old mission
  Sighting after;                    ///< by the new one
};

/// A room that one of the missions entered and the other did not.
struct OneSidedRoom {
  RoomId room = 0;  ///< of the plan of the mission that entered it
  std::string name;
  bool was_before = true;  ///< the old mission was in it; else the new one alone
  double area_m2 = 0.0;
  double seen_share = 0.0;  ///< of its floor that the other saw from outside, [0, 1]
};

/// What two visits of a building say of each other; all in the old building's metres.
struct PlanChanges {
  Pose2 old_from_new;
  std::vector<Change> changes;
  std::vector<OneSidedRoom> rooms;
  std::vector<Polygon> not_seen_again;  ///< of what the old mission saw; nothing is said of it
  double compared_m2 = 0.0;             ///< floor that both saw
  bool tells_changes = true;  ///< false for sonars, whose echoes do not tell what stands where
};

}  // namespace roomatlas
