// SPDX-License-Identifier: GPL-3.0-or-later
// A pose graph of your own: a robot drives twice round a block of 20 m by 10 m. Its odometry turns
// too far at each corner; where it comes back to a corner, it knows the place again, once wrongly.
#include <cmath>
#include <cstdint>
#include <iostream>
#include <roomatlas/solve/optimize.hpp>

int main() {
  using namespace roomatlas;
  const Eigen::Matrix3d information =  // 0.1 m and 2 degrees, one standard deviation
      Eigen::Vector3d(100.0, 100.0, std::pow(radians(2.0), -2)).asDiagonal();

  PoseGraph graph;
  for (std::int32_t corner = 0; corner <= 8; ++corner) {
    graph.ids.push_back(corner);
    if (corner == 0) continue;
    const double side_m = corner % 2 == 1 ? 20.0 : 10.0;
    const Pose2 driven{side_m, 0.0, radians(90.0 + 1.5)};
    graph.edges.push_back({corner - 1, corner, EdgeKind::odometry, driven, information});
    if (corner < 4) continue;
    graph.edges.push_back({corner - 4, corner, EdgeKind::loop, Pose2{}, information});
  }
  graph.edges.push_back({1, 6, EdgeKind::loop, Pose2{}, information});  // opposite corners

  const OptimizeResult result = optimize(graph, {.robust = true});
  std::cout.precision(2);
  std::cout << std::fixed << "chi-square before " << result.initial_chi_square << ", after "
            << result.chi_square << "; expected at most " << result.expected.high << '\n';
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    if (result.edges[e].accepted) continue;
    std::cout << "rejected: " << graph.edges[e].from << " to " << graph.edges[e].to << ": "
              << words(result.edges[e]) << '\n';
  }
  for (const Pose2& pose : result.poses) {
    std::cout << pose.x_m << " m, " << pose.y_m << " m, " << degrees(pose.theta_rad) << " deg\n";
  }
  return result.trusted ? 0 : 1;
}
