// SPDX-License-Identifier: GPL-3.0-or-later
#include "occupancy_world.hpp"

#include "label_contacts.hpp"
#include "label_rooms.hpp"
#include "trace_cells.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas::io {
namespace {

constexpr double kSpread_m = 0.3;         // of labels: less leaves lines between rooms without any
constexpr double kNarrowestDoor_m = 0.3;  // labels that touch over less do so by chance

/// The picture's cells with a rim of unknown ones, so that walls may stand just outside of it.
CellGrid<MapCell> cells_of(const Picture& picture, const OccupancyScale& scale) {
  const CellGrid<int>& values = picture.values;
  CellGrid<MapCell> cells(values.width() + 2, values.height() + 2, MapCell::unknown);
  for (int y = 0; y < values.height(); ++y) {
    for (int x = 0; x < values.width(); ++x) {
      cells(x + 1, y + 1) = cell_of(values(x, y), picture.white, scale);
    }
  }
  return cells;
}

bool touches_free(const CellGrid<MapCell>& cells, int x, int y) {
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (cells.get(x + dx, y + dy, MapCell::unknown) == MapCell::free) return true;
    }
  }
  return false;
}

/// 1 where a wall stands.
CellGrid<int> obstacles_of(const CellGrid<MapCell>& cells, std::int64_t& closed_cells) {
  CellGrid<int> obstacles(cells.width(), cells.height(), 0);
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) {
      if (cells(x, y) == MapCell::free) continue;
      const bool is_closed = cells(x, y) == MapCell::unknown && touches_free(cells, x, y);
      if (is_closed) ++closed_cells;
      obstacles(x, y) = is_closed || cells(x, y) == MapCell::occupied ? 1 : 0;
    }
  }
  return obstacles;
}

/// The regions of free cells in cells, the largest first.
std::vector<Polygon> free_regions(const CellGrid<MapCell>& cells) {
  CellGrid<int> free(cells.width(), cells.height(), 0);
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) free(x, y) = cells(x, y) == MapCell::free ? 1 : 0;
  }
  std::vector<Polygon> regions;
  for (TracedRegion& region : trace_cells(free)) regions.push_back(std::move(region.outline));
  std::stable_sort(regions.begin(), regions.end(),
                   [](const Polygon& a, const Polygon& b) { return area(a) > area(b); });
  return regions;
}

/// From cells with the rim to world metres.
class ToWorld {
 public:
  explicit ToWorld(const OccupancyScale& scale) : scale_(scale) {}

  Point2 operator()(const Point2& cell) const {
    return scale_.world_from_picture * Point2(scale_.resolution_m * (cell - Point2(1.0, 1.0)));
  }
  Polygon operator()(Polygon polygon) const {
    for (Point2& point : polygon.outer) point = (*this)(point);
    for (Ring& hole : polygon.holes) {
      for (Point2& point : hole) point = (*this)(point);
    }
    return polygon;
  }

 private:
  const OccupancyScale& scale_;
};

CellGrid<int> with_rim(const Picture& labels) {
  CellGrid<int> grid(labels.values.width() + 2, labels.values.height() + 2, 0);
  for (int y = 0; y < labels.values.height(); ++y) {
    for (int x = 0; x < labels.values.width(); ++x) {
      grid(x + 1, y + 1) = std::max(0, labels.values(x, y));
    }
  }
  return grid;
}

void add_doors(const CellGrid<int>& labels, const ToWorld& to_world, FloorPlan& plan) {
  std::int64_t narrow = 0;
  for (const LabelContact& contact : label_contacts(labels)) {
    PlanDoor door;
    door.jambs = {to_world(contact.ends.a), to_world(contact.ends.b)};
    door.width_m = (door.jambs.b - door.jambs.a).norm();
    if (door.width_m < kNarrowestDoor_m - 1e-9) {
      ++narrow;
      continue;
    }
    door.id = static_cast<std::int64_t>(plan.doors.size()) + 1;
    door.room_a = contact.first;
    door.room_b = contact.second;
    plan.doors.push_back(door);
  }
  if (narrow > 0) {
    plan.issues.push_back({Severity::note, "", 0, "doors",
                           std::to_string(narrow) + " places where two labels touch are narrower "
                                                    "than 0.3 m and are not taken for doors"});
  }
  if (plan.doors.empty() && plan.rooms.size() > 1) {
    plan.issues.push_back({Severity::warning, "", 0, "doors",
                           "no two labels touch, so the world has rooms but no doors: draw the "
                           "labels up to 0.3 m from each other in the doorways"});
  }
}

/// The labels that count: on free cells, spread to those beside them.
CellGrid<int> room_cells(const CellGrid<MapCell>& cells, const Picture& labels, int most_steps,
                         FloorPlan& plan) {
  CellGrid<int> grid = with_rim(labels);
  CellGrid<char> free(cells.width(), cells.height(), 0);
  std::int64_t dropped = 0;
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) {
      free(x, y) = cells(x, y) == MapCell::free ? 1 : 0;
      if (free(x, y) == 1 || grid(x, y) == 0) continue;
      grid(x, y) = 0;
      ++dropped;
    }
  }
  if (dropped > 0) {
    plan.issues.push_back(
        {Severity::note, "", 0, "rooms",
         std::to_string(dropped) + " labelled pixels are not free and belong to no room"});
  }
  return spread_labels(grid, free, most_steps);
}

std::string size_text(const Picture& picture) {
  return std::to_string(picture.values.width()) + " x " + std::to_string(picture.values.height());
}

}  // namespace

FloorPlan world_of_occupancy(const Picture& picture, const OccupancyScale& scale,
                             const std::optional<Picture>& labels, const std::string& name) {
  if (labels && size_text(*labels) != size_text(picture)) {
    throw InputError(name + ": has " + size_text(picture) + " pixels, and its room labels have " +
                     size_text(*labels) + ": expected the same size");
  }
  const CellGrid<MapCell> cells = cells_of(picture, scale);
  FloorPlan plan;
  std::int64_t closed_cells = 0;
  const CellGrid<int> obstacles = obstacles_of(cells, closed_cells);
  const ToWorld to_world(scale);
  for (const TracedRegion& region : trace_cells(obstacles)) {
    plan.walls.push_back(to_world(region.outline));
  }
  require_floor({cells.begin(), cells.end()}, name);
  for (const Polygon& region : free_regions(cells)) plan.free_space.push_back(to_world(region));
  if (closed_cells > 0) {
    plan.issues.push_back({Severity::note, "", 0, "walls",
                           std::to_string(closed_cells) + " unknown cells beside free ones are "
                                                          "taken for walls"});
  }
  if (!labels) return plan;
  const int most_steps = static_cast<int>(std::ceil(kSpread_m / scale.resolution_m - 1e-9));
  const CellGrid<int> rooms = room_cells(cells, *labels, most_steps, plan);
  plan.rooms = rooms_of_labels(rooms, [&](const Point2& corner) { return to_world(corner); });
  add_doors(rooms, to_world, plan);
  return plan;
}

}  // namespace roomatlas::io
