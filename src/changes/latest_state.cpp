// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/changes/latest_state.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "extent.hpp"

namespace roomatlas {
namespace {

constexpr double kRobot_m = 0.15;  // around the path all is floor, see `OccupancyOptions`

/// Visits the cells in or near an outline: `visit(cell, is_inside)`.
template <typename Visit>
void for_each_cell_near(const Polygon& outline, double near_m, const CellFrame& frame,
                        Visit visit) {
  Box2 box;
  for (const Point2& corner : outline.outer) box.extend(corner);
  if (box.empty()) return;
  const Point2 margin = Point2::Constant(near_m + frame.cell_m);
  for_each_cell(CellBox{frame.cell_of(box.min - margin), frame.cell_of(box.max + margin)},
                [&](const Cell& cell) {
                  const double off_m = changes::distance_m(outline, frame.center_of(cell));
                  if (off_m <= near_m) visit(cell, off_m == 0.0);
                });
}

/// What a mission says of a cell; neither where it hardly saw it.
struct SeenInCell {
  bool is_hit = false;
  bool is_clear = false;
};

SeenInCell seen_in(const Cell& cell, const ReflectionMap& map, const ChangeOptions& options) {
  const CellCounts seen = map.at(cell);
  const bool is_hit = seen.hits > 0 && seen.reflected_share() > options.clear_share;
  return {is_hit, !is_hit && seen.passes >= options.min_passes};
}

/// Forgets what stood where nothing stands now.
void forget_gone(const Polygon& outline, const ReflectionMap& now, const ChangeOptions& options,
                 LatestState& state, TileGrid<bool>& is_gone) {
  ReflectionMap& counts = state.evidence.counts;
  for_each_cell_near(outline, options.apart_m, counts.frame(), [&](const Cell& cell, bool inside) {
    const auto [is_hit, is_clear] = seen_in(cell, now, options);
    if (inside ? is_hit : !is_clear) return;
    counts.set(cell, {0, counts.at(cell).passes});
    is_gone.edit(cell) = true;
  });
}

/// Forgets that beams passed where something stands now.
void forget_passes(const Polygon& outline, const ReflectionMap& now, const ChangeOptions& options,
                   std::uint16_t time, LatestState& state) {
  ReflectionMap& counts = state.evidence.counts;
  for_each_cell_near(outline, options.apart_m, counts.frame(), [&](const Cell& cell, bool inside) {
    const auto [is_hit, is_clear] = seen_in(cell, now, options);
    if (inside ? is_clear : !is_hit) return;
    counts.set(cell, {counts.at(cell).hits, 0});
    state.times.since.edit(cell) = time;
  });
}

/// The line of what fills a door, whose outline begins with a side along it.
Segment2 line_of(const Polygon& gap) {
  const Ring& ring = gap.outer;
  return {(ring.at(0) + ring.at(3)) / 2.0, (ring.at(1) + ring.at(2)) / 2.0};
}

/// From jamb to jamb, as deep as the wall.
Polygon gap_of(const Segment2& line, const ChangeOptions& options) {
  const Point2 along = (line.b - line.a).normalized();
  const Point2 across = options.door_reach_m * Point2(-along.y(), along.x());
  return {{line.a - across, line.b - across, line.b + across, line.a + across}, {}};
}

/// Takes out of the surfaces what shuts a door; those of its jambs stay.
void remove_panel(const Segment2& line, const ChangeOptions& options,
                  std::vector<SurfacePoint>& surfaces) {
  constexpr double kAlongCosine = 0.5;
  const Polygon gap = gap_of(line, options);
  const Point2 along = (line.b - line.a).normalized();
  std::erase_if(surfaces, [&](const SurfacePoint& surface) {
    return std::abs(direction(surface.normal_rad).dot(along)) < kAlongCosine &&
           contains(gap, surface.at);
  });
}

/// Keeps in mind which doors are shut, and how they were seen before.
void note_doors(const std::vector<Change>& changes, const ChangeOptions& options,
                LatestState& state) {
  for (const Change& change : changes) {
    if (change.kind > ChangeKind::door_turned) continue;
    std::erase_if(state.shut, [&](const ShutDoor& door) {
      return ((door.line.a + door.line.b) / 2.0 - change.at).norm() < kSameDoor_m;
    });
    if (change.kind != ChangeKind::door_shut) continue;
    const auto gap = std::find_if(
        change.appeared.begin(), change.appeared.end(),
        [&](const Polygon& outline) { return changes::distance_m(outline, change.at) == 0.0; });
    if (gap == change.appeared.end()) continue;
    ShutDoor door{line_of(*gap), {}};
    const ReflectionMap& counts = state.evidence.counts;
    for_each_cell_near(
        gap_of(door.line, options), 0.0, counts.frame(),
        [&](const Cell& cell, bool) { door.open.emplace_back(cell, counts.at(cell)); });
    state.shut.push_back(std::move(door));
  }
}

/// Whether all that a visit says of where the robot stood still holds.
bool holds_around(const VisitTimes& times, AsrId visit, const Cell& at, int reach) {
  bool holds = true;
  for_each_cell({{at.x - reach, at.y - reach}, {at.x + reach + 1, at.y + reach + 1}},
                [&](const Cell& cell) { holds = holds && times.holds(visit, cell); });
  return holds;
}

/// Leaves out poses where something stands by now.
void cut_path(const VisitTimes& times, BuildingEvidence& evidence) {
  const CellFrame& frame = evidence.counts.frame();
  const int reach = static_cast<int>(std::lround(kRobot_m / frame.cell_m));
  std::vector<Pose2> path;
  std::vector<AsrId> asrs;
  for (std::size_t i = 0; i < evidence.building_from_robot.size(); ++i) {
    const Pose2& pose = evidence.building_from_robot[i];
    const AsrId visit = evidence.asr_of_pose[i];
    if (!holds_around(times, visit, frame.cell_of(pose.position()), reach)) continue;
    path.push_back(pose);
    asrs.push_back(visit);
  }
  evidence.building_from_robot = std::move(path);
  evidence.asr_of_pose = std::move(asrs);
}

/// Takes what is known of altered cells from the state.
void take_altered(const LatestState& state, BuildingEvidence& evidence) {
  const CellFrame& frame = evidence.counts.frame();
  const auto is_altered = [&](const SurfacePoint& surface) {
    return state.times.since.at(frame.cell_of(surface.at)) > 0;
  };
  state.times.since.for_each([&](const Cell& cell, std::uint16_t since) {
    if (since > 0) evidence.counts.set(cell, state.evidence.counts.at(cell));
  });
  std::erase_if(evidence.surfaces, is_altered);
  std::copy_if(state.evidence.surfaces.begin(), state.evidence.surfaces.end(),
               std::back_inserter(evidence.surfaces), is_altered);
}

}  // namespace

void take_in(const BuildingEvidence& later, const std::vector<Change>& changes,
             const ChangeOptions& options, LatestState& state) {
  std::uint16_t time = 0;
  for (const auto& [visit, when] : state.times.of_visit) {
    time = std::max(time, static_cast<std::uint16_t>(when + 1));
  }
  note_doors(changes, options, state);
  TileGrid<bool> is_gone;
  for (const Change& change : changes) {
    for (const Polygon& outline : change.gone) {
      forget_gone(outline, later.counts, options, state, is_gone);
    }
    for (const Polygon& outline : change.appeared) {
      forget_passes(outline, later.counts, options, time, state);
    }
  }
  const CellFrame& frame = state.evidence.counts.frame();
  std::erase_if(state.evidence.surfaces,
                [&](const SurfacePoint& surface) { return is_gone.at(frame.cell_of(surface.at)); });
  is_gone.for_each([&](const Cell& cell, bool gone) {
    if (gone) state.times.since.edit(cell) = time;
  });
  for (const AsrId visit : later.asr_of_pose) state.times.of_visit[visit] = time;
  add_seen(later, state.evidence);
}

BuildingEvidence as_drafted(BuildingEvidence all, const LatestState& state,
                            const ChangeOptions& options) {
  VisitTimes times = state.times;
  take_altered(state, all);
  for (const ShutDoor& door : state.shut) {
    for (const auto& [cell, counts] : door.open) {
      all.counts.set(cell, counts);
      times.since.edit(cell) = 0;
    }
    remove_panel(door.line, options, all.surfaces);
  }
  cut_path(times, all);
  return all;
}

}  // namespace roomatlas
