// SPDX-License-Identifier: GPL-3.0-or-later
#include "pose_graphs.hpp"

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "roomatlas/io/files/path.hpp"
#include "roomatlas/io/trajectories/pose_graph_file.hpp"
#include "roomatlas/solve/optimize.hpp"
#include "values.hpp"

namespace py = pybind11;

namespace roomatlas::python {
namespace {

struct GivenEdge {
  std::int64_t from = 0;
  std::int64_t to = 0;
  std::array<double, 3> pose{};  ///< x_m, y_m, theta_rad
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();
};

/// As in files: edges between ids that differ by 1 are odometry, all others loops.
PoseGraph graph_of(const std::vector<GivenEdge>& edges) {
  PoseGraph graph;
  for (const GivenEdge& edge : edges) {
    graph.ids.push_back(edge.from);
    graph.ids.push_back(edge.to);
  }
  std::ranges::sort(graph.ids);
  const auto repeated = std::ranges::unique(graph.ids);
  graph.ids.erase(repeated.begin(), repeated.end());
  const auto index_of = [&](std::int64_t id) {
    return static_cast<std::int32_t>(std::ranges::lower_bound(graph.ids, id) - graph.ids.begin());
  };
  for (const GivenEdge& edge : edges) {
    const bool follows = std::max(edge.from, edge.to) - std::min(edge.from, edge.to) == 1;
    graph.edges.push_back({index_of(edge.from),
                           index_of(edge.to),
                           follows ? EdgeKind::odometry : EdgeKind::loop,
                           {edge.pose[0], edge.pose[1], wrap_angle(edge.pose[2])},
                           edge.information});
  }
  return graph;
}

py::list verdicts(const PoseGraph& graph, const OptimizeResult& result) {
  using namespace py::literals;
  py::list to;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const PoseEdge& edge = graph.edges[e];
    const EdgeVerdict& verdict = result.edges[e];
    to.append(py::dict("source"_a = graph.ids[static_cast<std::size_t>(edge.from)],
                       "target"_a = graph.ids[static_cast<std::size_t>(edge.to)],
                       "is_loop"_a = edge.kind != EdgeKind::odometry,
                       "accepted"_a = verdict.accepted, "weight"_a = verdict.weight,
                       "chi_square"_a = verdict.chi_square, "reason"_a = words(verdict)));
  }
  return to;
}

py::dict solved(const PoseGraph& graph, Issues told, bool robust) {
  using namespace py::literals;
  OptimizeOptions options;
  options.robust = robust;
  OptimizeResult result;
  {
    const py::gil_scoped_release released;
    result = optimize(graph, options);
  }
  Trajectory poses_by_id;
  for (std::size_t i = 0; i < graph.ids.size(); ++i) {
    poses_by_id.push_back({static_cast<double>(graph.ids[i]), result.poses[i]});
  }
  told.insert(told.end(), result.issues.begin(), result.issues.end());
  return py::dict(
      "ids"_a = graph.ids, "poses"_a = poses(poses_by_id), "converged"_a = result.converged,
      "trusted"_a = result.trusted, "message"_a = result.message,
      "iterations"_a = result.iterations, "initial_chi_square"_a = result.initial_chi_square,
      "chi_square"_a = result.chi_square,
      "expected_chi_square"_a = py::make_tuple(result.expected.low, result.expected.high),
      "edges"_a = verdicts(graph, result), "issues"_a = issues(told));
}

}  // namespace

void bind_pose_graphs(py::module_& core) {
  core.def("optimize_file", [](const Path& file, bool robust) {
    PoseGraphFile read;
    {
      const py::gil_scoped_release released;
      read = read_pose_graph(file);
    }
    return solved(read.graph, std::move(read.issues), robust);
  });
  core.def(
      "optimize_edges",
      [](const std::vector<
             std::tuple<std::int64_t, std::int64_t, std::array<double, 3>, Eigen::Matrix3d>>& edges,
         bool robust) {
        std::vector<GivenEdge> given;
        for (const auto& [from, to, pose, information] : edges) {
          given.push_back({from, to, pose, information});
        }
        return solved(graph_of(given), {}, robust);
      });
}

}  // namespace roomatlas::python
