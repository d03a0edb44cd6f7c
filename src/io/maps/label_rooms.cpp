// SPDX-License-Identifier: GPL-3.0-or-later
#include "label_rooms.hpp"

#include "trace_cells.hpp"

#include <algorithm>
#include <map>

namespace roomatlas::io {

std::vector<PlanRoom> rooms_of_labels(const CellGrid<int>& labels,
                                      const std::function<Point2(const Point2&)>& to_world) {
  std::map<int, PlanRoom> by_label;
  for (TracedRegion& region : trace_cells(labels)) {
    for (Point2& point : region.outline.outer) point = to_world(point);
    for (Ring& hole : region.outline.holes) {
      for (Point2& point : hole) point = to_world(point);
    }
    by_label[region.value].parts.push_back(std::move(region.outline));
  }
  std::vector<PlanRoom> rooms;
  for (auto& [label, room] : by_label) {
    room.id = label;
    room.name = std::to_string(label);
    std::stable_sort(room.parts.begin(), room.parts.end(),
                     [](const Polygon& a, const Polygon& b) { return area(a) > area(b); });
    for (const Polygon& part : room.parts) room.area_m2 += area(part);
    room.label_point = interior_point(room.parts.front(), 0.1);
    rooms.push_back(std::move(room));
  }
  return rooms;
}

}  // namespace roomatlas::io
