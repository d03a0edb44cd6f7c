// SPDX-License-Identifier: GPL-3.0-or-later
// The solver on recorded and generated pose graphs, beside Ceres as its documentation shows it.
// Everything counts: ordering, initial guess, iterations. Times are processor time. Each row is
// measured in a process of its own, so that its peak memory is that row's.
#include <ceres/autodiff_cost_function.h>
#include <ceres/autodiff_manifold.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <glog/logging.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>

#include "posegraph_files.hpp"
#include "roomatlas/io/trajectories/pose_graph_file.hpp"
#include "roomatlas/solve/optimize.hpp"
#include "support/generated_pose_graph.hpp"

namespace roomatlas {
namespace {

template <typename T>
T normalized(const T& angle) {
  const T two_pi(2.0 * kPi);
  return angle - two_pi * ceres::floor((angle + T(kPi)) / two_pi);
}

struct AngleSum {
  template <typename T>
  bool Plus(const T* angle, const T* step, T* sum) const {
    *sum = normalized(*angle + *step);
    return true;
  }
  template <typename T>
  bool Minus(const T* a, const T* b, T* difference) const {
    *difference = normalized(*a - *b);
    return true;
  }
};

/// The error term of Ceres' example of pose graphs in the plane, with g2o's frame of the error.
struct AutodiffError {
  const PoseEdge* edge;
  Eigen::Matrix3d root;
  template <typename T>
  // Ceres passes each block by itself. NOLINTNEXTLINE(readability-function-size)
  bool operator()(const T* xa, const T* ya, const T* ta, const T* xb, const T* yb, const T* tb,
                  T* residual) const {
    const T c = ceres::cos(*ta);
    const T s = ceres::sin(*ta);
    const T dx = *xb - *xa;
    const T dy = *yb - *ya;
    const T x = c * dx + s * dy - T(edge->from_from_to.x_m);
    const T y = c * dy - s * dx - T(edge->from_from_to.y_m);
    const double cm = std::cos(edge->from_from_to.theta_rad);
    const double sm = std::sin(edge->from_from_to.theta_rad);
    Eigen::Matrix<T, 3, 1> error(cm * x + sm * y, cm * y - sm * x,
                                 normalized(*tb - *ta - T(edge->from_from_to.theta_rad)));
    Eigen::Map<Eigen::Matrix<T, 3, 1>> result(residual);
    result = root.cast<T>() * error;
    return true;
  }
};

struct Row {
  double seconds = 0.0;
  double chi_square = -1.0;
  int iterations = 0;
  double peak_mb = 0.0;
};

/// Of this process: both solvers have one thread, and other programs do not count.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Row plain_ceres(const PoseGraph& graph, std::vector<Pose2> poses) {
  const double start = processor_seconds();
  ceres::Problem problem;
  for (const PoseEdge& edge : graph.edges) {
    Pose2& a = poses[static_cast<std::size_t>(edge.from)];
    Pose2& b = poses[static_cast<std::size_t>(edge.to)];
    auto* cost = new ceres::AutoDiffCostFunction<AutodiffError, 3, 1, 1, 1, 1, 1, 1>(
        new AutodiffError{&edge, edge.information.llt().matrixU()});
    problem.AddResidualBlock(cost, nullptr, &a.x_m, &a.y_m, &a.theta_rad, &b.x_m, &b.y_m,
                             &b.theta_rad);
  }
  for (Pose2& pose : poses) {
    problem.SetManifold(&pose.theta_rad, new ceres::AutoDiffManifold<AngleSum, 1, 1>);
  }
  problem.SetParameterBlockConstant(&poses[0].x_m);
  problem.SetParameterBlockConstant(&poses[0].y_m);
  problem.SetParameterBlockConstant(&poses[0].theta_rad);
  ceres::Solver::Options options;
  options.max_num_iterations = 100;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  Row row;
  row.seconds = processor_seconds() - start;
  row.chi_square = chi_square(graph, poses);
  row.iterations = static_cast<int>(summary.iterations.size());
  return row;
}

Row ours(const PoseGraph& graph) {
  const double start = processor_seconds();
  const OptimizeResult result = optimize(graph, {});
  return {processor_seconds() - start, result.chi_square, result.iterations, 0.0};
}

/// Runs `measure` some times in a process of its own.
Row in_own_process(int times, const std::function<std::function<Row()>()>& prepare) {
  int ends[2];
  if (pipe(ends) != 0) return {};
  const pid_t child = fork();
  if (child == 0) {
    const std::function<Row()> measure = prepare();
    std::vector<Row> rows;
    for (int i = 0; i < times; ++i) rows.push_back(measure());
    std::ranges::sort(rows, {}, &Row::seconds);
    const bool sent = write(ends[1], &rows[rows.size() / 2], sizeof(Row)) == sizeof(Row);
    _exit(sent ? 0 : 1);
  }
  Row row;
  close(ends[1]);
  if (read(ends[0], &row, sizeof(Row)) != sizeof(Row)) row.chi_square = -1.0;
  close(ends[0]);
  rusage usage{};
  int status = 0;
  wait4(child, &status, 0, &usage);
  row.peak_mb = static_cast<double>(usage.ru_maxrss) / 1024.0;
  return row;
}

/// What the file has, or poses along odometry and the first edges that lead on.
std::vector<Pose2> start_of(const PoseGraph& graph) {
  if (!graph.guess.empty()) return graph.guess;
  std::vector<Pose2> poses(graph.ids.size());
  std::vector<char> known(graph.ids.size(), 0);
  known[0] = 1;
  for (bool any = true; any;) {
    any = false;
    for (const PoseEdge& edge : graph.edges) {
      const auto from = static_cast<std::size_t>(edge.from);
      const auto to = static_cast<std::size_t>(edge.to);
      if (known[from] == known[to]) continue;
      if (known[from] != 0) poses[to] = poses[from] * edge.from_from_to;
      if (known[to] != 0) poses[from] = poses[to] * inverse(edge.from_from_to);
      known[from] = known[to] = 1;
      any = true;
    }
  }
  return poses;
}

void print_header() {
  std::printf("%-26s %8s %8s | %10s %4s %14s %8s | %10s %4s %14s | %6s\n", "graph", "nodes",
              "edges", "ours ms", "it", "chi-square", "MB", "Ceres ms", "it", "chi-square",
              "ratio");
}

void print_row(const std::string& name, int times, bool with_ceres,
               const std::function<PoseGraph()>& load) {
  std::size_t nodes = 0;
  std::size_t edges = 0;
  {
    const PoseGraph graph = load();
    nodes = graph.ids.size();
    edges = graph.edges.size();
  }
  const Row us = in_own_process(times, [&] { return [graph = load()] { return ours(graph); }; });
  std::printf("%-26s %8zu %8zu | %10.2f %4d %14.6f %8.0f | ", name.c_str(), nodes, edges,
              us.seconds * 1e3, us.iterations, us.chi_square, us.peak_mb);
  if (with_ceres) {
    const Row them = in_own_process(
        times, [&] { return [graph = load()] { return plain_ceres(graph, start_of(graph)); }; });
    const bool right = them.chi_square < us.chi_square * (1.0 + 1e-3) + 1e-9;
    std::printf("%10.2f %4d %14.6f | %6.1f%s\n", them.seconds * 1e3, them.iterations,
                them.chi_square, them.seconds / us.seconds, right ? "" : "  Ceres is wrong");
  } else {
    std::printf("%10s %4s %14s | %6s\n", "-", "-", "-", "-");
  }
  std::fflush(stdout);
}

}  // namespace
}  // namespace roomatlas

int main(int argc, char** argv) {
  using namespace roomatlas;
  FLAGS_minloglevel = google::GLOG_FATAL;
  google::InitGoogleLogging(argv[0]);
  (void)argc;
  print_header();
  for (const auto& file : bench::pose_graph_files()) {
    print_row(bench::short_name(file), 9, true, [&] { return read_pose_graph(file).graph; });
  }
  for (const std::int32_t rooms : {1000, 10000, 100000, 1000000}) {
    const int times = rooms <= 1000 ? 9 : rooms <= 10000 ? 5 : rooms <= 100000 ? 3 : 1;
    print_row("rooms, generated", times, rooms <= 10000,
              [&] { return test::room_graph(rooms).graph; });
  }
  return 0;
}
