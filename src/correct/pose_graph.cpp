// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/correct/pose_graph.hpp"

#include <cmath>

namespace roomatlas {

Eigen::Vector3d edge_error(const PoseEdge& edge, const Pose2& from, const Pose2& to) {
  const Pose2 from_from_to = inverse(from) * to;
  const Pose2 error = inverse(edge.from_from_to) * from_from_to;
  return {error.x_m, error.y_m,
          wrap_angle(to.theta_rad - from.theta_rad - edge.from_from_to.theta_rad)};
}

double chi_square(const PoseEdge& edge, const Pose2& from, const Pose2& to) {
  const Eigen::Vector3d error = edge_error(edge, from, to);
  return error.dot(edge.information * error);
}

double chi_square(const PoseGraph& graph, std::span<const Pose2> poses) {
  double sum = 0.0;
  for (const PoseEdge& edge : graph.edges) {
    sum += chi_square(edge, poses[static_cast<std::size_t>(edge.from)],
                      poses[static_cast<std::size_t>(edge.to)]);
  }
  return sum;
}

}  // namespace roomatlas
