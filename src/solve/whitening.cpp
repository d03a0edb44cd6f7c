// SPDX-License-Identifier: GPL-3.0-or-later
#include "whitening.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace roomatlas {

Eigen::Matrix3d whitening(const Eigen::Matrix3d& information) {
  const Eigen::LLT<Eigen::Matrix3d> cholesky(information);
  if (cholesky.info() == Eigen::Success) return cholesky.matrixU();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(information);
  return eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() *
         eigen.eigenvectors().transpose();
}

}  // namespace roomatlas
