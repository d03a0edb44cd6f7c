// SPDX-License-Identifier: GPL-3.0-or-later
#include "pose_factors.hpp"

#include <cmath>

#include "whitening.hpp"

namespace roomatlas {
namespace {

Eigen::Matrix2d rotation(double angle_rad) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  return (Eigen::Matrix2d() << c, -s, s, c).finished();
}

/// dR/dtheta = R * kQuarterTurn.
const Eigen::Matrix2d kQuarterTurn = (Eigen::Matrix2d() << 0, -1, 1, 0).finished();

using RowMajor3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

}  // namespace

RelativePoseFactor::RelativePoseFactor(const Pose2& i_from_j, const Eigen::Matrix3d& information)
    : i_from_j_(i_from_j), whitening_(whitening(information)) {}

bool RelativePoseFactor::Evaluate(double const* const* parameters, double* residuals,
                                  double** jacobians) const {
  const Eigen::Map<const Eigen::Vector3d> pose_i(parameters[0]);
  const Eigen::Map<const Eigen::Vector3d> pose_j(parameters[1]);
  const Eigen::Matrix2d i_from_world = rotation(pose_i(2)).transpose();
  const Eigen::Matrix2d j_from_i = rotation(i_from_j_.theta_rad).transpose();
  const Point2 step_i = i_from_world * (pose_j.head<2>() - pose_i.head<2>());
  Eigen::Vector3d error;
  error.head<2>() = j_from_i * (step_i - i_from_j_.position());
  error(2) = wrap_angle(pose_j(2) - pose_i(2) - i_from_j_.theta_rad);
  Eigen::Map<Eigen::Vector3d> result(residuals);
  result = whitening_ * error;
  if (jacobians == nullptr) return true;

  const Eigen::Matrix2d j_from_world = j_from_i * i_from_world;
  if (jacobians[0] != nullptr) {
    Eigen::Matrix3d by_i = Eigen::Matrix3d::Zero();
    by_i.topLeftCorner<2, 2>() = -j_from_world;
    by_i.topRightCorner<2, 1>() = -(j_from_i * kQuarterTurn * step_i);
    by_i(2, 2) = -1.0;
    Eigen::Map<RowMajor3> by_pose(jacobians[0]);
    by_pose = whitening_ * by_i;
  }
  if (jacobians[1] != nullptr) {
    Eigen::Matrix3d by_j = Eigen::Matrix3d::Zero();
    by_j.topLeftCorner<2, 2>() = j_from_world;
    by_j(2, 2) = 1.0;
    Eigen::Map<RowMajor3> by_pose(jacobians[1]);
    by_pose = whitening_ * by_j;
  }
  return true;
}

bool HeadingFactor::Evaluate(double const* const* parameters, double* residuals,
                             double** jacobians) const {
  residuals[0] = wrap_angle(parameters[0][2] - measured_rad_) / sigma_rad_;
  if (jacobians == nullptr || jacobians[0] == nullptr) return true;
  jacobians[0][0] = 0.0;
  jacobians[0][1] = 0.0;
  jacobians[0][2] = 1.0 / sigma_rad_;
  return true;
}

std::unique_ptr<ceres::CostFunction> relative_pose_cost(const Pose2& i_from_j,
                                                        const Eigen::Matrix3d& information) {
  return std::make_unique<RelativePoseFactor>(i_from_j, information);
}

}  // namespace roomatlas
