// SPDX-License-Identifier: GPL-3.0-or-later
// Values of the library as numpy's arrays, lists and dictionaries.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <vector>

#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas::python {

/// N x 2, metres.
[[nodiscard]] pybind11::array_t<double> points(const std::vector<Point2>& points);
/// N x 4: timestamp_s, x_m, y_m, theta_rad.
[[nodiscard]] pybind11::array_t<double> poses(const Trajectory& trajectory);
/// Pairs of an outer ring and a list of holes.
[[nodiscard]] pybind11::list polygons(const std::vector<Polygon>& polygons);

[[nodiscard]] pybind11::list rooms(const FloorPlan& plan);
[[nodiscard]] pybind11::list doors(const FloorPlan& plan);
[[nodiscard]] pybind11::list furniture(const FloorPlan& plan);
[[nodiscard]] pybind11::list issues(const Issues& issues);

}  // namespace roomatlas::python
