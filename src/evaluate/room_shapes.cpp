// SPDX-License-Identifier: GPL-3.0-or-later
#include "room_shapes.hpp"

#include <algorithm>

#include "roomatlas/planar/union.hpp"

namespace roomatlas {
namespace {

bool apart(const Box2& a, const Box2& b) {
  return a.empty() || b.empty() || (a.min.array() > b.max.array()).any() ||
         (b.min.array() > a.max.array()).any();
}

}  // namespace

std::vector<RoomShape> shapes_of(const FloorPlan& plan, const Pose2& truth_from_plan) {
  std::vector<RoomShape> shapes;
  for (const PlanRoom& room : plan.rooms) {
    std::vector<Polygon> parts;
    for (const Polygon& part : room.parts) parts.push_back(transformed(truth_from_plan, part));
    RoomShape shape{union_of(parts), 0.0, {}};
    for (const Polygon& part : shape.parts) {
      shape.area_m2 += area(part);
      for (const Point2& point : part.outer) shape.box.extend(point);
    }
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

double Overlaps::iou(std::size_t room, std::size_t true_room) const {
  const double shared = shared_m2[room][true_room];
  const double either_m2 = rooms[room].area_m2 + true_rooms[true_room].area_m2 - shared;
  return either_m2 > 0.0 ? std::clamp(shared / either_m2, 0.0, 1.0) : 0.0;
}

double Overlaps::shared_of_room_m2(std::size_t room) const {
  double sum_m2 = 0.0;
  for (const double shared : shared_m2[room]) sum_m2 += shared;
  return sum_m2;
}

double Overlaps::largest_of_room_m2(std::size_t room) const {
  double largest_m2 = 0.0;
  for (const double shared : shared_m2[room]) largest_m2 = std::max(largest_m2, shared);
  return largest_m2;
}

double Overlaps::shared_of_true_room_m2(std::size_t true_room) const {
  double sum_m2 = 0.0;
  for (const auto& row : shared_m2) sum_m2 += row[true_room];
  return sum_m2;
}

double Overlaps::largest_of_true_room_m2(std::size_t true_room) const {
  double largest_m2 = 0.0;
  for (const auto& row : shared_m2) largest_m2 = std::max(largest_m2, row[true_room]);
  return largest_m2;
}

Overlaps overlaps_of(const FloorPlan& plan, const FloorPlan& truth, const Pose2& truth_from_plan) {
  Overlaps overlaps{shapes_of(plan, truth_from_plan), shapes_of(truth, Pose2{}), {}};
  for (const RoomShape& room : overlaps.rooms) {
    std::vector<double>& row = overlaps.shared_m2.emplace_back();
    for (const RoomShape& true_room : overlaps.true_rooms) {
      row.push_back(apart(room.box, true_room.box) ? 0.0
                                                   : overlap_area(room.parts, true_room.parts));
    }
  }
  return overlaps;
}

}  // namespace roomatlas
