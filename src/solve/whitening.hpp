// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace roomatlas {

/// W with W' W = information, so that |W r|^2 = r' Omega r. Upper triangular where Omega is
/// positive definite; for a non-diagonal Omega the lower factor would be wrong. Where Omega has a
/// zero eigenvalue, W is not triangular.
[[nodiscard]] Eigen::Matrix3d whitening(const Eigen::Matrix3d& information);

}  // namespace roomatlas
