// SPDX-License-Identifier: GPL-3.0-or-later
#include "factors.hpp"

#include <cmath>
#include <utility>

namespace roomatlas {
namespace {

Eigen::Matrix2d rotation(double angle_rad) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  return (Eigen::Matrix2d() << c, -s, s, c).finished();
}

/// dR/dtheta = R * kQuarterTurn.
const Eigen::Matrix2d kQuarterTurn = (Eigen::Matrix2d() << 0, -1, 1, 0).finished();

}  // namespace

bool RelativeHeadingFactor::Evaluate(double const* const* parameters, double* residuals,
                                     double** jacobians) const {
  residuals[0] = wrap_angle(parameters[1][0] - parameters[0][0] - measured_rad_) / sigma_rad_;
  if (jacobians == nullptr) return true;
  if (jacobians[0] != nullptr) jacobians[0][0] = -1.0 / sigma_rad_;
  if (jacobians[1] != nullptr) jacobians[1][0] = 1.0 / sigma_rad_;
  return true;
}

PivotLoopFactor::PivotLoopFactor(std::vector<Point2> steps_m, double sigma_m)
    : steps_m_(std::move(steps_m)), sigma_m_(sigma_m) {
  set_num_residuals(2);
  mutable_parameter_block_sizes()->assign(steps_m_.size(), 1);
}

bool PivotLoopFactor::Evaluate(double const* const* parameters, double* residuals,
                               double** jacobians) const {
  Point2 sum = Point2::Zero();
  for (std::size_t k = 0; k < steps_m_.size(); ++k) {
    const Point2 step = rotation(parameters[k][0]) * steps_m_[k];
    sum += step;
    if (jacobians != nullptr && jacobians[k] != nullptr) {
      Eigen::Map<Point2> result(jacobians[k]);
      result = kQuarterTurn * step / sigma_m_;
    }
  }
  Eigen::Map<Point2> result(residuals);
  result = sum / sigma_m_;
  return true;
}

}  // namespace roomatlas
