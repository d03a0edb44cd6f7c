// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "extent.hpp"
#include "roomatlas/changes/find_changes.hpp"
#include "witnesses.hpp"

namespace roomatlas::changes {

/// A group of cells that stands in one of the missions, with what both say of it.
struct Altered {
  bool is_new = false;         ///< it stands in the new mission; else it stood in the old one
  std::vector<Point2> points;  ///< middles of its cells, old building's metres
  Witness before;
  Witness after;
};

/// A door of either plan.
struct DoorPlace {
  Segment2 jambs;
  double width_m = 0.0;
  std::optional<std::int64_t> old_id;
  std::vector<Segment2> leaves;  ///< as they stood, in either plan

  [[nodiscard]] Point2 middle() const { return (jambs.a + jambs.b) / 2.0; }
};

/// The doors of the old plan, and those of the new one that it does not have.
[[nodiscard]] std::vector<DoorPlace> doors_of(const FloorPlan& before, const FloorPlan& after);

enum class ThingKind {
  gap,   ///< what shuts a door
  leaf,  ///< of a door that stands open
  wall,
  furniture,
};

/// What something is by the plan in which it stands.
struct Thing {
  ThingKind kind = ThingKind::furniture;
  std::size_t door = 0;              ///< of gap and leaf: its place among the doors
  std::optional<std::size_t> piece;  ///< of furniture: its place in that plan
};

/// @param plan of the mission in which it stands
/// @param other plan
[[nodiscard]] Thing thing_of(const Altered& altered, const FloorPlan& plan, const FloorPlan& other,
                             const std::vector<DoorPlace>& doors, const ChangeOptions& options);

/// Names what was altered, and puts together what is one change: a door's leaf and its gap, the two
/// faces of a wall, a piece of furniture seen from several sides, and what was moved.
/// @returns changes numbered from 1 on: doors, walls, furniture; each by its place
[[nodiscard]] std::vector<Change> changes_of(const std::vector<Altered>& altered,
                                             const FloorPlan& before, const FloorPlan& after,
                                             const ChangeOptions& options);

}  // namespace roomatlas::changes
