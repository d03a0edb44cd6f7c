// SPDX-License-Identifier: GPL-3.0-or-later
// What tests of Ceres' cost functions ask of each: that its Jacobian is its residual's derivative.
#pragma once

#include <ceres/cost_function.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "roomatlas/core/pose2.hpp"
#include "support/numeric_derivative.hpp"

namespace roomatlas::test {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The factor's value and Jacobian with all its parameter blocks in one vector.
struct Evaluated {
  Eigen::VectorXd residuals;
  RowMajor jacobian;
};

inline Evaluated evaluate(const ceres::CostFunction& factor, const Eigen::VectorXd& state) {
  const auto& sizes = factor.parameter_block_sizes();
  std::vector<const double*> parameters;
  std::vector<RowMajor> blocks;
  Eigen::Index offset = 0;
  for (const int size : sizes) {
    parameters.push_back(state.data() + offset);
    blocks.emplace_back(factor.num_residuals(), size);
    offset += size;
  }
  std::vector<double*> jacobians;
  for (RowMajor& block : blocks) jacobians.push_back(block.data());
  Evaluated result{Eigen::VectorXd(factor.num_residuals()),
                   RowMajor(factor.num_residuals(), offset)};
  EXPECT_EQ(offset, state.size());
  EXPECT_TRUE(factor.Evaluate(parameters.data(), result.residuals.data(), jacobians.data()));
  offset = 0;
  for (const RowMajor& block : blocks) {
    result.jacobian.middleCols(offset, block.cols()) = block;
    offset += block.cols();
  }
  return result;
}

inline void expect_jacobian_is_numeric(const ceres::CostFunction& factor,
                                       const Eigen::VectorXd& state) {
  const auto value = [&](const Eigen::VectorXd& at) { return evaluate(factor, at).residuals; };
  const Eigen::MatrixXd numeric = numeric_jacobian(value, state);
  EXPECT_LT((evaluate(factor, state).jacobian - numeric).cwiseAbs().maxCoeff(), 1e-6)
      << "at " << state.transpose();
}

/// Any angle, but often one within a degree of +-pi.
class Angles {
 public:
  double next() {
    const double any = uniform_(random_) * kPi;
    const double near_pi = kPi + uniform_(random_) * radians(1.0);
    return near_(random_) ? wrap_angle(near_pi) : any;
  }
  double coordinate_m() { return 10.0 * uniform_(random_); }

 private:
  std::mt19937 random_{7};
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
  std::bernoulli_distribution near_{0.5};
};

/// At an error of half a turn the residual jumps, and has no derivative.
inline bool jumps(double error_rad) {
  return std::abs(std::abs(wrap_angle(error_rad)) - kPi) < 1e-3;
}

}  // namespace roomatlas::test
