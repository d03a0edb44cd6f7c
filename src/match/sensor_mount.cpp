// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/match/sensor_mount.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr std::size_t kLeastMotions = 8;
constexpr int kRounds = 12;
constexpr double kRobustM = 0.02;  // residuals beyond it lose weight (Cauchy)

using Unknowns = Eigen::Vector4d;  // lever arm, cosine and sine of the heading
using Rows = Eigen::Matrix<double, 2, 4>;

/// `(R - 1) t - H s = -r`: R and r the robot's turn and way, s the sensor's way, H its heading.
Rows rows_of(const SeenMotion& motion) {
  const double cosine = std::cos(motion.of_robot.theta_rad);
  const double sine = std::sin(motion.of_robot.theta_rad);
  Rows rows;
  rows << cosine - 1.0, -sine, -motion.of_sensor.x_m, motion.of_sensor.y_m,  //
      sine, cosine - 1.0, -motion.of_sensor.y_m, -motion.of_sensor.x_m;
  return rows;
}

Eigen::Vector2d residual_of(const SeenMotion& motion, const Unknowns& mount) {
  return rows_of(motion) * mount + motion.of_robot.position();
}

struct Fit {
  Unknowns mount = Unknowns::Zero();
  Eigen::Matrix4d information = Eigen::Matrix4d::Zero();  ///< for residuals of 1 m
  double weight = 0.0;                                    ///< of all motions
  double squares = 0.0;                                   ///< of residuals, weighted
};

std::optional<Fit> fit(const std::vector<SeenMotion>& motions) {
  Fit fit;
  bool is_first = true;
  for (int round = 0; round < kRounds; ++round) {
    Fit next;
    Unknowns sum = Unknowns::Zero();
    for (const SeenMotion& motion : motions) {
      const double off_m = is_first ? 0.0 : residual_of(motion, fit.mount).norm();
      const double weight = 1.0 / (1.0 + off_m * off_m / (kRobustM * kRobustM));
      const Rows rows = rows_of(motion);
      next.information += weight * rows.transpose() * rows;
      sum -= weight * rows.transpose() * motion.of_robot.position();
      next.weight += weight;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> values(next.information,
                                                                Eigen::EigenvaluesOnly);
    if (values.eigenvalues()(0) < 1e-6) return std::nullopt;
    next.mount = next.information.ldlt().solve(sum);
    is_first = false;
    fit = next;
  }
  for (const SeenMotion& motion : motions) {
    const double off_m = residual_of(motion, fit.mount).norm();
    fit.squares += off_m * off_m / (1.0 + off_m * off_m / (kRobustM * kRobustM));
  }
  return fit;
}

}  // namespace

std::optional<SensorMount> mount_from_motions(const std::vector<SeenMotion>& motions) {
  if (motions.size() < kLeastMotions) return std::nullopt;
  const auto found = fit(motions);
  if (!found) return std::nullopt;
  SensorMount mount;
  const double cosine = found->mount(2);
  const double sine = found->mount(3);
  const double length = std::hypot(cosine, sine);
  if (length < 0.1) return std::nullopt;
  mount.length_scale = 1.0 / length;
  mount.robot_from_sensor = {found->mount(0), found->mount(1), std::atan2(sine, cosine)};
  const double freedom = std::max(1.0, 2.0 * found->weight - 4.0);
  const double variance = found->squares / freedom;
  const Eigen::Matrix4d covariance = variance * found->information.inverse();
  mount.position_sigma_m = std::sqrt(covariance(0, 0) + covariance(1, 1));
  const Eigen::Vector2d across(-sine / length, cosine / length);
  mount.heading_sigma_rad =
      std::sqrt(across.dot(covariance.bottomRightCorner<2, 2>() * across)) / length;
  double squares = 0.0;
  double turn_squares = 0.0;
  for (const SeenMotion& motion : motions) {
    squares += residual_of(motion, found->mount).squaredNorm();
    const double off = wrap_angle(motion.of_sensor.theta_rad - motion.of_robot.theta_rad);
    turn_squares += off * off;
    double& turned = motion.of_robot.theta_rad > 0.0 ? mount.left_rad : mount.right_rad;
    turned += std::abs(motion.of_robot.theta_rad);
    mount.way_m += motion.of_robot.position().norm();
  }
  const auto count = static_cast<double>(motions.size());
  mount.off_m = std::sqrt(squares / count);
  mount.off_rad = std::sqrt(turn_squares / count);
  return mount;
}

}  // namespace roomatlas
