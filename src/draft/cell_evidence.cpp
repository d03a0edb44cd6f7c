// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_evidence.hpp"

#include <algorithm>
#include <cmath>

#include "roomatlas/grid/tile_grid.hpp"
#include "roomatlas/polyline/distance_field.hpp"

namespace roomatlas {
namespace {

constexpr double kSample_m = 0.025;    // between places of a cell: walls are 0.1 m thick and more
constexpr double kAlong_m = 0.05;      // between places on a border
constexpr double kDoorReach_m = 0.05;  // from an opening's line, that is in the opening
constexpr double kRoomAtTheRim = 1e3;  // of the building's frame: no room reaches it

/// Faces of walls by stretches, to be asked whether a point lies in a wall.
bool is_in_body(const Point2& at, const WallBody& body, const Walls& walls) {
  const WallFace& front = walls.faces[body.front];
  const double depth_m = front.offset_m - at.dot(front.normal());
  if (depth_m <= 0.0 || depth_m >= body.thickness_m) return false;
  const double along_m = at.dot(front.along());
  return std::any_of(body.stretches.begin(), body.stretches.end(), [&](const Interval& stretch) {
    return along_m > stretch.low_m && along_m < stretch.high_m;
  });
}

/// The walls' bodies by the cells that they lie in.
class BodyLookup {
 public:
  BodyLookup(const Walls& walls, const CellFrame& frame, const CellDomain& domain)
      : walls_(walls), frame_(frame), domain_(domain) {
    for (std::size_t i = 0; i < walls.bodies.size(); ++i) mark(i);
  }

  [[nodiscard]] bool contains(const Point2& at) const {
    const std::uint32_t list = list_of_.at(frame_.cell_of(at));
    const std::vector<std::size_t>& bodies = lists_[list];
    return std::any_of(bodies.begin(), bodies.end(), [&](std::size_t body) {
      return is_in_body(at, walls_.bodies[body], walls_);
    });
  }

 private:
  void mark(std::size_t index) {
    const WallBody& body = walls_.bodies[index];
    const WallFace& front = walls_.faces[body.front];
    const double step_m = frame_.cell_m / 2.0;
    for (const Interval& stretch : body.stretches) {
      for (double along_m = stretch.low_m; along_m < stretch.high_m + step_m; along_m += step_m) {
        for (double depth_m = 0.0; depth_m < body.thickness_m + step_m; depth_m += step_m) {
          const Cell cell = frame_.cell_of(front.at(along_m) - depth_m * front.normal());
          if (!domain_.contains(cell)) continue;
          std::uint32_t& list = list_of_.edit(cell);
          if (list == 0) {
            list = static_cast<std::uint32_t>(lists_.size());
            lists_.emplace_back();
          }
          if (lists_[list].empty() || lists_[list].back() != index) lists_[list].push_back(index);
        }
      }
    }
  }

  const Walls& walls_;
  CellFrame frame_;
  CellDomain domain_;
  std::vector<std::vector<std::size_t>> lists_{{}};  ///< of bodies; the first is of no cell
  TileGrid<std::uint32_t> list_of_;
};

/// The cells of openings: borders there part rooms without a wall.
CellMask in_openings(const RoomSeeds& seeds, const Occupancy& occupancy) {
  CellMask mask(occupancy.free.domain);
  for (const Door& opening : seeds.openings) {
    for_each_cell_on_line(occupancy.frame.cell_of(opening.jambs.a),
                          occupancy.frame.cell_of(opening.jambs.b), [&](const Cell& cell) {
                            mask.set(cell, true);
                            return true;
                          });
  }
  return dilated(mask, static_cast<int>(std::lround(kDoorReach_m / occupancy.frame.cell_m)));
}

/// How many points of a run, from the one in `where` on, surely lie beyond all that was seen: up to
/// the next cell of the domain, one at least.
std::int64_t points_beyond(const Arrangement::Run& run, std::int64_t from, const Cell& where,
                           const CellDomain& domain, const CellFrame& frame) {
  std::int64_t count = run.count - from;
  bool is_next = true;
  domain.for_each_span(where.y, [&](const CellDomain::Span& span) {
    if (span.from <= where.x || !is_next) return;
    is_next = false;
    const double way_m = span.from * frame.cell_m - run.at(from).x();
    count = std::min(count, static_cast<std::int64_t>(way_m / run.step_m));
  });
  return std::max<std::int64_t>(1, count);
}

}  // namespace

std::vector<CellEvidence> cell_evidence(const Arrangement& arrangement, const Walls& walls,
                                        const Occupancy& occupancy, const RoomSeeds& seeds,
                                        const DraftOptions& options) {
  const CellDomain& domain = occupancy.free.domain;
  CellMask not_floor(domain);
  for_each_cell(domain, [&](const Cell& cell) {
    not_floor.set(cell, !(occupancy.free.at(cell) && seeds.room_of_cell.get(cell) > 0));
  });
  const Raster<float> depth_cells = distance_inside(not_floor);
  const BodyLookup bodies(walls, occupancy.frame, domain);
  std::vector<CellEvidence> cells(static_cast<std::size_t>(arrangement.cell_count()));
  std::vector<std::int64_t> in_body(cells.size(), 0);
  std::vector<std::int64_t> places(cells.size(), 0);
  constexpr double kPlace_m2 = kSample_m * kSample_m;
  const auto add = [&](int index, const Point2& at, const Cell& where) {
    CellEvidence& cell = cells[static_cast<std::size_t>(index)];
    if (bodies.contains(at)) ++in_body[static_cast<std::size_t>(index)];
    const RoomId room = seeds.room_of_cell.get(where);
    if (occupancy.free.at(where)) {
      (room > 0 ? cell.floor_m2[room] : cell.other_floor_m2) += kPlace_m2;
    } else if (room > 0 && options.hidden_cost > 0.0) {
      cell.hidden_m2[room] += kPlace_m2;
    } else if (!occupancy.seen.at(where)) {
      const double depth_m = depth_cells[where] * occupancy.frame.cell_m;
      (depth_m > options.deep_m ? cell.deep_unseen_m2 : cell.unseen_m2) += kPlace_m2;
    }
  };
  arrangement.for_each_run(kSample_m, [&](int index, const Arrangement::Run& run) {
    places[static_cast<std::size_t>(index)] += run.count;
    for (std::int64_t i = 0; i < run.count;) {
      const Cell where = occupancy.frame.cell_of(run.at(i));
      if (domain.contains(where)) {
        add(index, run.at(i++), where);
        continue;
      }
      const std::int64_t far = points_beyond(run, i, where, domain, occupancy.frame);
      cells[static_cast<std::size_t>(index)].deep_unseen_m2 += static_cast<double>(far) * kPlace_m2;
      i += far;
    }
  });
  for (std::size_t i = 0; i < cells.size(); ++i) {
    cells[i].is_wall_body = 2 * in_body[i] > places[i];
    if (places[i] == 0) cells[i].unseen_m2 = arrangement.area_m2(static_cast<int>(i));  // a sliver
  }
  return cells;
}

std::vector<LabelCosts> costs_of(const Arrangement& arrangement,
                                 const std::vector<CellEvidence>& evidence,
                                 const std::vector<RoomId>& rooms, const DraftOptions& options) {
  std::vector<LabelCosts> costs(evidence.size());
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    const CellEvidence& cell = evidence[i];
    std::map<RoomId, double> price_of;  // of its floor, seen and hidden, if it is not the room's
    for (const auto& [room, area_m2] : cell.floor_m2)
      price_of[room] += options.solid_cost * area_m2;
    for (const auto& [room, area_m2] : cell.hidden_m2)
      price_of[room] += options.hidden_cost * area_m2;
    double floor_cost = 0.0;
    for (const auto& [room, price] : price_of) floor_cost += price;
    double room_cost = options.unseen_cost * cell.unseen_m2 +
                       options.deep_unseen_cost * cell.deep_unseen_m2 +
                       options.other_floor_cost * options.unseen_cost * cell.other_floor_m2;
    if (cell.is_wall_body) {
      room_cost += options.wall_body_cost * arrangement.area_m2(static_cast<int>(i));
    }
    costs[i].solid = cell.is_wall_body ? 0.0 : floor_cost;
    costs[i].other = floor_cost + room_cost;
    for (const auto& [room, price] : price_of) {
      const auto at = std::lower_bound(rooms.begin(), rooms.end(), room);
      if (at == rooms.end() || *at != room) continue;
      costs[i].rooms[static_cast<int>(at - rooms.begin()) + 1] = floor_cost - price + room_cost;
    }
  }
  const auto close = [&](int cell) {
    LabelCosts& cost = costs[static_cast<std::size_t>(cell)];
    cost.other += kRoomAtTheRim;
    for (auto& [label, of_room] : cost.rooms) of_room += kRoomAtTheRim;
  };
  close(0);
  for (const Arrangement::Border& border : arrangement.borders()) {
    if (border.left == 0) close(border.right);
    if (border.right == 0) close(border.left);
  }
  return costs;
}

std::vector<LabelBorder> borders_of(const Arrangement& arrangement, const Occupancy& occupancy,
                                    const RoomSeeds& seeds, const DraftOptions& options) {
  const CellMask near_obstacle = dilated(occupancy.obstacle, 1);
  const CellMask openings = in_openings(seeds, occupancy);
  std::vector<LabelBorder> borders;
  for (const Arrangement::Border& border : arrangement.borders()) {
    const Point2 way = border.segment.b - border.segment.a;
    const int count = std::max(1, static_cast<int>(way.norm() / kAlong_m));
    double free = 0.0, door = 0.0, unknown = 0.0;
    for (int i = 0; i < count; ++i) {
      const Cell cell = occupancy.frame.cell_of(border.segment.a + way * ((i + 0.5) / count));
      if (near_obstacle.at(cell)) continue;
      (openings.at(cell) ? door : occupancy.free.at(cell) ? free : unknown) += 1.0 / count;
    }
    const double a_metre =
        border.is_wall ? options.border_cost + options.faint_cost * std::exp(-border.prominence_m /
                                                                             options.prominence_m)
                       : options.border_cost + options.no_wall_cost;
    const double cost = way.norm() * (a_metre + options.unknown_cost * unknown +
                                      options.free_cost * free + options.door_cost * door);
    borders.push_back({border.left, border.right, cost, cost});
  }
  return borders;
}

}  // namespace roomatlas
