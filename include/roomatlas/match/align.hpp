// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <optional>
#include <span>

#include "roomatlas/match/local_map.hpp"

namespace roomatlas {

/// What is known of a pose beforehand.
struct PosePrior {
  Pose2 mean;
  double position_sigma_m = 0.0;
  double heading_sigma_rad = 0.0;
};

struct AlignOptions {
  double first_gate_m = 0.25;      ///< points farther from any face find no partner at first ...
  double last_gate_m = 0.12;       ///< ... and in the end
  double min_normal_cosine = 0.7;  ///< partners face the same way
  double robust_m = 0.05;          ///< residuals beyond it lose weight (Cauchy); also their sigma
  double corner_weight = 0.15;     ///< of a point whose partner has no direction; 0: such pairs go
                                   ///< by the point's own
  int max_iterations = 12;  ///< the gate is at its smallest after 0.6 of them; fewer end unsettled
};

struct ScanAlignment {
  Pose2 map_from_points;
  int points = 0;   ///< that were hits
  int matched = 0;  ///< of these, with a partner
  /// Sum of the weighted squares' Hessian over x, y (map axes) and theta, for residuals of
  /// 1 m standard deviation; without the prior's.
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
};

/// Moves points onto a map: point-to-line Gauss-Newton (Chen and Medioni 1991; Censi 2008) with
/// the nearest face that looks the same way as partner, chosen anew in each iteration while the
/// gate shrinks. Points that are no hits are left out.
[[nodiscard]] ScanAlignment align(const LocalMap& map, std::span<const ScanPoint> points,
                                  const Pose2& map_from_points,
                                  const std::optional<PosePrior>& prior,
                                  const AlignOptions& options);

struct CorrelateOptions {
  double reach_m = 0.15;            ///< searched to both sides of the start ...
  double step_m = 0.05;             ///< half a cell; larger steps can pass by the best place
  double reach_rad = radians(4.0);  ///< ... and so is the heading
  double step_rad = radians(1.0);   ///< larger: points far off pass by their wall
  double penalty = 0.05;            ///< lost at one sigma off the prior; scores lie in [0, 1]
  int max_points = 90;              ///< of a sweep; more cost time
};

/// The pose of a small window around the prior's mean where hits fall on the most certain cells
/// (correlative scan matching after Olson 2009, over HIMM's certainty).
[[nodiscard]] Pose2 correlate(const LocalMap& map, std::span<const ScanPoint> points,
                              const PosePrior& prior, const CorrelateOptions& options);

}  // namespace roomatlas
