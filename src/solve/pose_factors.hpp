// SPDX-License-Identifier: GPL-3.0-or-later
// Residuals of a pose graph. Included only below src/solve (and by its tests).
#pragma once

#include <ceres/sized_cost_function.h>

#include <Eigen/Core>

#include "roomatlas/solve/relative_pose_cost.hpp"

namespace roomatlas {

/// A relative pose i_from_j measured between two poses (x, y, theta) of the building:
///   r = W [ R_ij' (R_i' (t_j - t_i) - t_ij) ; wrap(theta_j - theta_i - theta_ij) ]
/// with R_ij, t_ij, theta_ij of the measurement (g2o's convention). The angle wraps here, so that
/// the parameters need no manifold.
class RelativePoseFactor : public ceres::SizedCostFunction<3, 3, 3> {
 public:
  RelativePoseFactor(const Pose2& i_from_j, const Eigen::Matrix3d& information);
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  Pose2 i_from_j_;
  Eigen::Matrix3d whitening_;
};

/// A measured heading of a pose: r = wrap(theta - measured) / sigma.
class HeadingFactor : public ceres::SizedCostFunction<1, 3> {
 public:
  HeadingFactor(double measured_rad, double sigma_rad)
      : measured_rad_(measured_rad), sigma_rad_(sigma_rad) {}
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  double measured_rad_;
  double sigma_rad_;
};

}  // namespace roomatlas
