// SPDX-License-Identifier: GPL-3.0-or-later
// Residuals of the room graph. Included only below src/correct (and by its tests).
#pragma once

#include <ceres/cost_function.h>
#include <ceres/sized_cost_function.h>

#include <Eigen/Core>
#include <vector>

#include "roomatlas/core/pose2.hpp"

namespace roomatlas {

/// Heading of `to` relative to `from`: r = wrap(theta_to - theta_from - measured) / sigma.
class RelativeHeadingFactor : public ceres::SizedCostFunction<1, 1, 1> {
 public:
  RelativeHeadingFactor(double measured_rad, double sigma_rad)
      : measured_rad_(measured_rad), sigma_rad_(sigma_rad) {}
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  double measured_rad_;
  double sigma_rad_;
};

/// Walls that follow the building's direction: r = wrap(theta + wall - building - quarter turns)
/// / sigma, on a heading and the building's direction. How many quarter turns lie between is
/// decided before, at the initial guess.
/// @tparam kPoseSize 3 when the heading is the last element of a pose, 1 when it stands alone
template <int kPoseSize>
class WallDirectionFactor : public ceres::SizedCostFunction<1, kPoseSize, 1> {
 public:
  WallDirectionFactor(double wall_plus_quarters_rad, double sigma_rad)
      : offset_rad_(wall_plus_quarters_rad), sigma_rad_(sigma_rad) {}
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    residuals[0] =
        wrap_angle(parameters[0][kPoseSize - 1] + offset_rad_ - parameters[1][0]) / sigma_rad_;
    if (jacobians == nullptr) return true;
    if (jacobians[0] != nullptr) {
      for (int i = 0; i < kPoseSize; ++i) jacobians[0][i] = 0.0;
      jacobians[0][kPoseSize - 1] = 1.0 / sigma_rad_;
    }
    if (jacobians[1] != nullptr) jacobians[1][0] = -1.0 / sigma_rad_;
    return true;
  }

 private:
  double offset_rad_;
  double sigma_rad_;
};

/// The paper's model around a loop: the ASRs i, i+1 ... j turn about their entry pivots and their
/// positions follow, so that a pivot seen from i and again from j gives
///   r = sum over k of R(theta_k) step_k / sigma = 0
/// where step_k leads, in ASR k's frame, from its pivot to the next one. Parameters: the headings.
class PivotLoopFactor : public ceres::CostFunction {
 public:
  PivotLoopFactor(std::vector<Point2> steps_m, double sigma_m);
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  std::vector<Point2> steps_m_;
  double sigma_m_;
};

}  // namespace roomatlas
