// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include "roomatlas/correct/correction.hpp"
#include "roomatlas/correct/wall_direction.hpp"
#include "roomatlas/graph/room_graph.hpp"
#include "roomatlas/odometry/noise.hpp"

namespace roomatlas {

enum class CorrectionModel {
  se2,            ///< each ASR turns and moves
  rotation_only,  ///< the paper's: each ASR turns about its entry pivot, positions follow
};

/// How much each kind of measurement is trusted: standard deviations.
struct CorrectOptions {
  CorrectionModel model = CorrectionModel::se2;
  bool use_wall_directions = true;  ///< off for buildings without right angles
  bool settle_on_walls = true;      ///< the building is laid along its walls edge by edge; off:
                                    ///< along the direction that its rooms have in common
  WallDirectionOptions walls;
  bool use_heading_bias = true;  ///< estimate odometry's drift from the walls, and take it out

  /// Of a pivot against the one before, over the whole way through an ASR. It grows with the way,
  /// not its root: over a room what is left of the bias goes one way. Smaller resists the walls'
  /// direction.
  OdometryNoise odometry{
      .position = {.still = 0.03, .per_m = 0.02},
      .heading = {.still = radians(1.0), .per_m = radians(0.6), .per_rad = 0.03}};
  double localized_position_m = 0.03;  ///< of a passage where the robot was found in the
                                       ///< room's map on both sides of it ...
  double localized_heading_deg = 0.6;  ///< ... and of its heading
  double doorway_position_m = 0.08;    ///< of a doorway seen twice
  double doorway_heading_deg = 5.0;    ///< two jambs a metre apart, each half a cell off
  double wall_heading_deg = 2.0;       ///< of a room's walls against the building's direction,
                                       ///< however long they are ...
  double wall_heading_deg_m = 15.0;    ///< ... with this over their length beside it
  double wall_gate_deg = 25.0;         ///< walls farther off follow no building direction;
                                       ///< at 45 a wing at an angle is bent into the rest
  double passage_robust_sigmas = 5.0;  ///< where the robot was lost once, passages off by more
                                       ///< lose weight too
  double robust_sigmas = 2.0;          ///< doorways and walls off by more lose weight (Cauchy)
  int max_iterations = 100;            ///< of Ceres; one that needs more has not converged
};

/// Corrects the poses of ASRs in the building (offline stage): odometry between consecutive ASRs,
/// doorways seen twice, and the direction of walls, by least squares with Ceres. One ASR of each
/// component, its first, keeps its odometry pose; then each component is turned as a whole, by at
/// most 45 degrees, so that its walls' direction is the x axis.
/// @param asrs ascending by id, vertices of `graph` in this order
/// @param start where the ASRs are already known to be, or empty: then along odometry, each turned
///   as the walls' directions say
/// @param habits of odometry, where they were found before: they hang on the ASRs and the driven
///   edges alone, and finding them takes longer than all else
/// @returns one entry an ASR; `converged` is false where the solver stopped early. An empty input
///   gives an empty, converged correction.
[[nodiscard]] Correction correct(const std::vector<Asr>& asrs, const RoomGraph& graph,
                                 const CorrectOptions& options, const Placement& start = {},
                                 const std::optional<EstimatedHabits>& habits = std::nullopt);

/// The correction of ASRs that have been placed by other means, such as a whole trajectory: they
/// stay there, but for the turn that makes the walls' direction the x axis; the graph's
/// measurements are reported, not solved.
/// @param placement of every ASR
/// @param walls_rad direction of the walls there, where it is known better than from single ASRs
[[nodiscard]] Correction correct_to(const std::vector<Asr>& asrs, const RoomGraph& graph,
                                    const Placement& placement, const CorrectOptions& options,
                                    std::optional<double> walls_rad = std::nullopt);

/// How much a measurement of the graph is trusted: inverse covariance of x, y, theta in the frame
/// of `to`, 1/m^2 and 1/rad^2.
[[nodiscard]] Eigen::Matrix3d information_of(const PassageEdge& edge,
                                             const CorrectOptions& options);

[[nodiscard]] Placement placement_of(const Correction& correction);

}  // namespace roomatlas
