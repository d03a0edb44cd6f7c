// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/solve/pose_graph.hpp"

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

double cauchy_loss(double chi_square, double cauchy_sigmas) {
  if (cauchy_sigmas == 0.0) return chi_square;
  const double squared = cauchy_sigmas * cauchy_sigmas;
  return squared * std::log1p(chi_square / squared);
}

double cauchy_weight(double chi_square, double cauchy_sigmas) {
  if (cauchy_sigmas == 0.0) return 1.0;
  return 1.0 / (1.0 + chi_square / (cauchy_sigmas * cauchy_sigmas));
}

double chi_square(const HeadingPrior& prior, const Pose2& pose) {
  const double off = pose.theta_rad - prior.theta_rad;
  const double error = (prior.modulo_quarter ? wrap_quarter(off) : wrap_angle(off));
  return error * error / (prior.sigma_rad * prior.sigma_rad);
}

double chi_square(const PoseGraph& graph, std::span<const Pose2> poses) {
  double sum = 0.0;
  for (const PoseEdge& edge : graph.edges) {
    sum += cauchy_loss(chi_square(edge, poses[static_cast<std::size_t>(edge.from)],
                                  poses[static_cast<std::size_t>(edge.to)]),
                       edge.cauchy_sigmas);
  }
  for (const HeadingPrior& prior : graph.headings) {
    sum += cauchy_loss(chi_square(prior, poses[static_cast<std::size_t>(prior.node)]),
                       prior.cauchy_sigmas);
  }
  return sum;
}

}  // namespace roomatlas
