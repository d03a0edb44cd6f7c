// SPDX-License-Identifier: GPL-3.0-or-later
// The module roomatlas._core: tasks and values for the Python files beside it, which have the
// documentation and all that is kind to people.
#include <glog/logging.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "new_store.hpp"
#include "output_places.hpp"
#include "pose_graphs.hpp"
#include "replaced_store.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "roomatlas/io/results/judgement_json.hpp"
#include "tasks.hpp"
#include "values.hpp"
#include "without_lock.hpp"

namespace py = pybind11;
using namespace py::literals;

namespace roomatlas::python {
namespace {

void bind_errors(py::module_& core) {
  const auto error = py::exception<void>(core, "Error", PyExc_RuntimeError);
  py::register_exception<UsageError>(core, "UsageError", error);
  py::register_exception<InputError>(core, "InputError", error);
  py::register_exception<NotEnoughError>(core, "NotEnoughError", error);
  py::register_exception<Interrupted>(core, "Interrupted", error);
}

void bind_plan(py::module_& core) {
  py::class_<DrawnPlan>(core, "Plan")
      .def_property_readonly("title", [](const DrawnPlan& self) { return self.plan.title; })
      .def_property_readonly("rooms", [](const DrawnPlan& self) { return rooms(self.plan); })
      .def_property_readonly("doors", [](const DrawnPlan& self) { return doors(self.plan); })
      .def_property_readonly("walls",
                             [](const DrawnPlan& self) { return polygons(self.plan.walls); })
      .def_property_readonly("furniture",
                             [](const DrawnPlan& self) { return furniture(self.plan); })
      .def_property_readonly("issues",
                             [](const DrawnPlan& self) { return issues(self.plan.issues); })
      .def("geojson", [](const DrawnPlan& self) { return to_geojson(self.plan); })
      .def(
          "svg",
          [](const DrawnPlan& self, bool trajectory, bool room_graph,
             std::optional<double> north_deg) {
            DrawOptions options;
            options.show_trajectory = trajectory;
            options.show_room_graph = room_graph;
            options.north_deg = north_deg;
            const py::gil_scoped_release released;
            return draw_plan(self.plan, self.annotations, options);
          },
          "trajectory"_a, "room_graph"_a, "north_deg"_a);
}

void bind_building(py::module_& core) {
  py::class_<Building>(core, "Building")
      .def_readonly("plan", &Building::drawn)
      .def_property_readonly("odometry", [](const Building& self) { return poses(self.odometry); })
      .def_property_readonly("trajectory",
                             [](const Building& self) { return poses(self.corrected); })
      .def_property_readonly("judgement", [](const Building& self) {
        return self.judgement ? std::optional(to_json(*self.judgement)) : std::nullopt;
      });
}

/// Cells as ROS's OccupancyGrid has them: -1 unknown, 0 to 100 the chance of an obstacle in per
/// cent; the first row lies lowest.
MapCells cells_of(const py::array_t<int, py::array::c_style | py::array::forcecast>& grid,
                  double resolution_m, const Pose2& origin) {
  if (grid.ndim() != 2) throw UsageError("segment: expected an array of rows and columns");
  if (!(resolution_m > 0.0)) {
    throw UsageError("segment: expected resolution_m > 0, the side of a cell in metres");
  }
  constexpr int kFree = 25;  // per cent, as ROS's map_server has it (0.25), and ...
  constexpr int kOccupied = 65;
  MapCells map;
  map.frame.cell_m = resolution_m;
  map.cells =
      Raster<MapCell>({{0, 0}, {static_cast<int>(grid.shape(1)), static_cast<int>(grid.shape(0))}});
  map.building_from_map = origin;
  const auto at = grid.unchecked<2>();
  for_each_cell(map.cells.domain.bounds(), [&](const Cell& cell) {
    const int value = at(cell.y, cell.x);
    if (value >= kOccupied) map.cells[cell] = MapCell::occupied;
    if (value >= 0 && value <= kFree) map.cells[cell] = MapCell::free;
  });
  return map;
}

void bind_tasks(py::module_& core) {
  core.def("build",
           [](const Path& input, const Path& store, const Path& former, double resolution_m,
              const std::string& parameters, int jobs, const py::object& callback) {
             without_lock(callback, [&](const Progress& progress) {
               build(input, store, former, resolution_m, parameters, jobs, progress);
             });
           });
  core.def("replace_store", &apps::replace_store);
  core.def("copy_store", [](const Path& store, const Path& place) {
    const PlaceLock lock = apps::lock_new_store(place, {store});
    apps::put_copy_in_place(store, place, [](const Path&) {});
  });
  py::class_<PlaceLock>(core, "PlaceLock").def(py::init(&apps::lock_new_store));
  core.def("read_building", &read_building, py::call_guard<py::gil_scoped_release>());
  core.def("segment_file", [](const Path& map, double resolution_m, const std::string& parameters,
                              const py::object& callback) {
    return without_lock(callback, [&](const Progress& progress) {
      return segment(map, resolution_m, parameters, progress);
    });
  });
  core.def(
      "segment_cells", [](const py::array_t<int, py::array::c_style | py::array::forcecast>& grid,
                          double resolution_m, const std::array<double, 3>& origin,
                          const std::string& parameters, const py::object& callback) {
        const MapCells map = cells_of(grid, resolution_m, {origin[0], origin[1], origin[2]});
        return without_lock(
            callback, [&](const Progress& progress) { return segment(map, parameters, progress); });
      });
  core.def("evaluate", &evaluate, py::call_guard<py::gil_scoped_release>());
  core.def("simulate", [](const Path& world, const Path& out, const std::string& format, bool tour,
                          const std::vector<std::array<double, 2>>& drive,
                          const std::string& parameters, const py::object& callback) {
    SimulationTask task{world, out, format, tour, {}};
    for (const auto& [x_m, y_m] : drive) task.drive.emplace_back(x_m, y_m);
    return without_lock(
        callback, [&](const Progress& progress) { return simulate(task, parameters, progress); });
  });
}

}  // namespace
}  // namespace roomatlas::python

PYBIND11_MODULE(_core, core) {
  FLAGS_minloglevel = google::GLOG_FATAL;  // Ceres logs even when asked to be silent
  core.attr("__version__") = ROOMATLAS_VERSION;
  roomatlas::python::bind_errors(core);
  roomatlas::python::bind_plan(core);
  roomatlas::python::bind_building(core);
  roomatlas::python::bind_pose_graphs(core);
  roomatlas::python::bind_tasks(core);
}
