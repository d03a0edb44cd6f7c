// SPDX-License-Identifier: GPL-3.0-or-later
#include "values.hpp"

#include <pybind11/stl.h>

namespace py = pybind11;

namespace roomatlas::python {
namespace {

py::array_t<double> table(std::size_t rows, py::ssize_t columns) {
  return py::array_t<double>({static_cast<py::ssize_t>(rows), columns});
}

py::array_t<double> line(const Segment2& segment) { return points({segment.a, segment.b}); }

}  // namespace

py::array_t<double> points(const std::vector<Point2>& from) {
  py::array_t<double> to = table(from.size(), 2);
  auto at = to.mutable_unchecked<2>();
  for (std::size_t i = 0; i < from.size(); ++i) {
    const auto row = static_cast<py::ssize_t>(i);
    at(row, 0) = from[i].x();
    at(row, 1) = from[i].y();
  }
  return to;
}

py::array_t<double> poses(const Trajectory& from) {
  py::array_t<double> to = table(from.size(), 4);
  auto at = to.mutable_unchecked<2>();
  for (std::size_t i = 0; i < from.size(); ++i) {
    const auto row = static_cast<py::ssize_t>(i);
    at(row, 0) = from[i].timestamp_s;
    at(row, 1) = from[i].pose.x_m;
    at(row, 2) = from[i].pose.y_m;
    at(row, 3) = from[i].pose.theta_rad;
  }
  return to;
}

py::list polygons(const std::vector<Polygon>& from) {
  py::list to;
  for (const Polygon& polygon : from) {
    py::list holes;
    for (const Ring& hole : polygon.holes) holes.append(points(hole));
    to.append(py::make_tuple(points(polygon.outer), holes));
  }
  return to;
}

py::list rooms(const FloorPlan& plan) {
  using namespace py::literals;
  py::list to;
  for (const PlanRoom& room : plan.rooms) {
    to.append(py::dict("id"_a = room.id, "name"_a = room.name, "kind"_a = to_string(room.kind),
                       "area_m2"_a = room.area_m2, "parts"_a = polygons(room.parts),
                       "label_point"_a = points({room.label_point}), "visits"_a = room.asrs));
  }
  return to;
}

py::list doors(const FloorPlan& plan) {
  using namespace py::literals;
  py::list to;
  for (const PlanDoor& door : plan.doors) {
    to.append(py::dict("id"_a = door.id, "kind"_a = to_string(door.kind),
                       "width_m"_a = door.width_m, "jambs"_a = line(door.jambs),
                       "opening"_a = points(door.opening),
                       "leaf"_a = door.leaf ? py::object(line(*door.leaf)) : py::none(),
                       "room_a"_a = door.room_a, "room_b"_a = door.room_b));
  }
  return to;
}

py::list furniture(const FloorPlan& plan) {
  py::list to;
  for (const PlanFurniture& piece : plan.furniture) {
    to.append(py::make_tuple(to_string(piece.kind), polygons({piece.outline})[0]));
  }
  return to;
}

py::list issues(const Issues& from) {
  py::list to;
  for (const Issue& issue : from) to.append(to_string(issue));
  return to;
}

}  // namespace roomatlas::python
