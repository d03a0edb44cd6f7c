// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <memory>

#include "roomatlas/core/pose2.hpp"

namespace ceres {
class CostFunction;
}

namespace roomatlas {

/// For problems of Ceres that hold more than a pose graph does: a relative pose measured between
/// two poses (x, y, theta; m, m, rad), g2o's error whitened. The angle wraps in the residual, so
/// that the parameters need no manifold.
/// @param information inverse covariance of x, y, theta in the frame of j: 1/m^2, 1/(m rad),
/// 1/rad^2
[[nodiscard]] std::unique_ptr<ceres::CostFunction> relative_pose_cost(
    const Pose2& i_from_j, const Eigen::Matrix3d& information);

}  // namespace roomatlas
