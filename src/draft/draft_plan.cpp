// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/draft_plan.hpp"

#include <algorithm>
#include <memory>
#include <set>

#include "arrangement.hpp"
#include "cell_evidence.hpp"
#include "label_cells.hpp"
#include "roomatlas/planar/simplify.hpp"

namespace roomatlas {
namespace {

constexpr int kMostSweeps = 3;            // over all labels; later ones change next to nothing
constexpr double kFrameMargin_m = 1.0;    // beyond all that was seen
constexpr double kRimTolerance_m = 0.08;  // of the lines along which floor ends
constexpr double kStraight_m = 0.003;     // of corners that are none: where other lines end
constexpr double kBeyond_m = 0.3;         // of where a wall goes on, to the line that ends it
constexpr double kShortestRim_m = 1.5;    // around; shorter are specks

std::vector<RoomId> rooms_of(const RoomSeeds& seeds) {
  std::set<RoomId> rooms;
  for (const auto room : seeds.room_of_cell.values) {
    if (room > 0) rooms.insert(room);
  }
  return {rooms.begin(), rooms.end()};
}

void add_frame(const Occupancy& occupancy, std::vector<DraftLine>& lines) {
  const double cell_m = occupancy.frame.cell_m;
  const CellBox& box = occupancy.free.domain.bounds();
  const Point2 low = cell_m * Point2(box.min.x, box.min.y) - Point2::Constant(kFrameMargin_m);
  const Point2 high = cell_m * Point2(box.max.x, box.max.y) + Point2::Constant(kFrameMargin_m);
  const Point2 corners[] = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  for (int i = 0; i < 4; ++i) lines.push_back({{corners[i], corners[(i + 1) % 4]}, 0.0, false});
}

/// The lines of faces, longer than the faces by what may be hidden, and those of openings.
std::vector<DraftLine> lines_of(const Walls& walls, const RoomSeeds& seeds,
                                const DraftOptions& options) {
  std::vector<DraftLine> lines;
  for (const WallFace& face : walls.faces) {
    const bool is_long = face.support_m() >= options.long_face_m;
    const double beyond_m = face.is_regular
                                ? (is_long ? options.extend_long_m : options.extend_short_m)
                                : (is_long ? options.extend_short_m : options.extend_slanted_m);
    const double low_m = std::min(face.low_m() - beyond_m, face.cover.front().low_m - kBeyond_m);
    const double high_m = std::max(face.high_m() + beyond_m, face.cover.back().high_m + kBeyond_m);
    lines.push_back({{face.at(low_m), face.at(high_m)}, face.prominence_m, true});
  }
  for (const Door& opening : seeds.openings) {
    const Point2 beyond = options.extend_door_m * (opening.jambs.b - opening.jambs.a).normalized();
    lines.push_back({{opening.jambs.a - beyond, opening.jambs.b + beyond}, 0.0, false});
    // And across the wall at its jambs: the faces of slanted walls do not go on through a door.
    const Point2 across = options.through_door_m * Point2(-beyond.y(), beyond.x()).normalized();
    for (const Point2& jamb : {opening.jambs.a, opening.jambs.b}) {
      lines.push_back({{jamb - across, jamb + across}, 0.0, false});
    }
  }
  return lines;
}

/// Where floor ends, as lines of no walls, in cells that hold both much floor and much unseen.
std::vector<DraftLine> rims_in_mixed_cells(const Arrangement& arrangement,
                                           const std::vector<CellEvidence>& evidence,
                                           const Occupancy& occupancy, const RoomSeeds& seeds,
                                           const DraftOptions& options) {
  CellMask is_mixed(occupancy.free.domain);
  bool any = false;
  std::vector<bool> mixed;
  for (const CellEvidence& cell : evidence) {
    double floor_m2 = 0.0;
    for (const auto& [room, area_m2] : cell.floor_m2) floor_m2 += area_m2;
    mixed.push_back(floor_m2 > options.mixed_free_m2 &&
                    cell.unseen_m2 + cell.deep_unseen_m2 > options.mixed_unseen_m2);
    any = any || mixed.back();
  }
  if (!any) return {};
  arrangement.for_each_run(occupancy.frame.cell_m, [&](int cell, const Arrangement::Run& run) {
    if (!mixed[static_cast<std::size_t>(cell)]) return;
    for (std::int64_t i = 0; i < run.count; ++i) {
      is_mixed.set(occupancy.frame.cell_of(run.at(i)), true);
    }
  });
  CellMask floor(occupancy.free.domain);
  for_each_cell(floor.domain, [&](const Cell& cell) {
    floor.set(cell, occupancy.free.at(cell) && seeds.room_of_cell.get(cell) > 0);
  });
  floor = eroded(dilated(floor, 1), 1);
  std::vector<DraftLine> lines;
  for (const CellBoundary& boundary : trace_boundaries(floor, occupancy.frame)) {
    const Ring ring = planar::simplified(boundary.edge_midpoints, kRimTolerance_m);
    if (length(ring) < kShortestRim_m) continue;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Segment2 side{ring[i], ring[(i + 1) % ring.size()]};
      const auto in_mixed = [&](double share) {
        return is_mixed.at(occupancy.frame.cell_of(side.a + share * (side.b - side.a)));
      };
      if (in_mixed(0.1) || in_mixed(0.5) || in_mixed(0.9)) lines.push_back({side, 0.0, false});
    }
  }
  return lines;
}

/// Solids inside a room that are too small to be walls become the room's.
void fill_holes(const Arrangement& arrangement, int rooms, double min_hole_m2,
                std::vector<int>& label_of) {
  // Components of solid cells over borders; those that touch one room alone and are small.
  const auto count = label_of.size();
  std::vector<std::vector<int>> next(count);
  for (const Arrangement::Border& border : arrangement.borders()) {
    next[static_cast<std::size_t>(border.left)].push_back(border.right);
    next[static_cast<std::size_t>(border.right)].push_back(border.left);
  }
  std::vector<bool> is_done(count, false);
  for (std::size_t start = 1; start < count; ++start) {
    if (is_done[start] || label_of[start] != 0) continue;
    std::vector<int> part = {static_cast<int>(start)};
    is_done[start] = true;
    std::set<int> around;
    bool is_open = false;
    double area_m2 = 0.0;
    for (std::size_t i = 0; i < part.size(); ++i) {
      area_m2 += arrangement.area_m2(part[i]);
      for (const int other : next[static_cast<std::size_t>(part[i])]) {
        if (other == 0) {
          is_open = true;
        } else if (label_of[static_cast<std::size_t>(other)] != 0) {
          around.insert(label_of[static_cast<std::size_t>(other)]);
        } else if (!is_done[static_cast<std::size_t>(other)]) {
          is_done[static_cast<std::size_t>(other)] = true;
          part.push_back(other);
        }
      }
    }
    if (is_open || around.size() != 1 || area_m2 >= min_hole_m2 || *around.begin() > rooms)
      continue;
    for (const int cell : part) label_of[static_cast<std::size_t>(cell)] = *around.begin();
  }
}

}  // namespace

Draft draft_plan(const Walls& walls, const Occupancy& occupancy, const RoomSeeds& seeds,
                 const DraftOptions& options) {
  const std::vector<RoomId> rooms = rooms_of(seeds);
  std::vector<DraftLine> lines = lines_of(walls, seeds, options);
  add_frame(occupancy, lines);
  auto arrangement = std::make_unique<Arrangement>(lines);
  std::vector<CellEvidence> evidence =
      cell_evidence(*arrangement, walls, occupancy, seeds, options);
  const std::vector<DraftLine> rims =
      rims_in_mixed_cells(*arrangement, evidence, occupancy, seeds, options);
  if (!rims.empty()) {
    lines.insert(lines.end(), rims.begin(), rims.end());
    arrangement = std::make_unique<Arrangement>(lines);
    evidence = cell_evidence(*arrangement, walls, occupancy, seeds, options);
  }
  const int labels = static_cast<int>(rooms.size()) + 1;
  std::vector<int> label_of =
      label_cells(costs_of(*arrangement, evidence, rooms, options),
                  borders_of(*arrangement, occupancy, seeds, options), labels, kMostSweeps);
  fill_holes(*arrangement, labels - 1, options.min_hole_m2, label_of);
  Draft draft;
  std::vector<int> group;
  for (std::size_t i = 0; i < label_of.size(); ++i) {
    const bool is_body = label_of[i] == 0 && evidence[i].is_wall_body;
    group.push_back(label_of[i] > 0 ? label_of[i] - 1 : is_body ? labels - 1 : -1);
  }
  auto polygons = arrangement->trace(group, labels);
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    if (polygons[i].empty() || area(polygons[i].front()) < options.min_room_m2) continue;
    draft.rooms.push_back({rooms[i], planar::simplified(polygons[i].front(), kStraight_m)});
  }
  draft.wall_bodies = std::move(polygons.back());
  return draft;
}

}  // namespace roomatlas
