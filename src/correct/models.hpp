// SPDX-License-Identifier: GPL-3.0-or-later
// The two models of the correction, without Ceres in their interface.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "roomatlas/correct/correct.hpp"

namespace roomatlas {

/// Everything that is measured, with ASRs as indices 0 ... n-1, ascending by id.
struct Measurements {
  struct Edge {
    std::size_t from = 0;
    std::size_t to = 0;
    PassageEdge measured;
  };
  std::vector<AsrId> ids;
  std::vector<Pose2> odom_from_asr;
  std::vector<int> component;
  std::vector<bool> is_fixed;  ///< the first ASR of each component
  std::vector<Edge> driven;
  std::vector<Edge> recognised;
  std::vector<std::optional<WallDirection>> walls;
  std::vector<double> path_length_m;
  std::vector<Turning> turning;
  EstimatedHabits habits;  ///< of `odom_from_asr`; `driven` is already without them
};

/// @param habits see `correct`
[[nodiscard]] Measurements measurements_of(const std::vector<Asr>& asrs, const RoomGraph& graph,
                                           const CorrectOptions& options,
                                           const std::optional<EstimatedHabits>& habits = {});

/// Poses, and the direction of the walls of each component.
struct PlacedAsrs {
  std::vector<Pose2> building_from_asr;
  std::vector<double> direction_rad;
};

/// Where to start: odometry from one ASR to the next, each turned as `asr_headings` says.
/// Without walls this is odometry. @param known where ASRs are known to be already; may be empty
[[nodiscard]] PlacedAsrs initial_guess(const Measurements& measurements,
                                       const CorrectOptions& options, const Placement& known);

/// The angle to add to an ASR's heading to compare it with the building's direction: its walls'
/// direction plus as many quarter turns as lie between at `state`. Nothing where the ASR's walls
/// are farther off than the gate.
[[nodiscard]] std::optional<double> wall_offset(const Measurements& measurements,
                                                const PlacedAsrs& state, std::size_t index,
                                                const CorrectOptions& options);

/// Standard deviation of a wall direction: long walls tell it well.
[[nodiscard]] double wall_sigma_rad(const WallDirection& wall, const CorrectOptions& options);

/// What an edge found offline came from.
[[nodiscard]] FactorKind kind_of(const PassageEdge& edge);

struct HeadingAndPosition {
  double heading_rad = 0.0;
  double position_m = 0.0;
};
/// Standard deviations of a driven or recognised edge.
[[nodiscard]] HeadingAndPosition sigmas_of(const PassageEdge& edge, const CorrectOptions& options);

struct ModelResult {
  PlacedAsrs state;
  bool converged = false;
  std::string message;
  double initial_cost = -1.0;  ///< as in `Correction`
  double final_cost = -1.0;    ///< as in `Correction`
  int iterations = 0;
  std::vector<FactorReport> factors;  ///< chi-square before is at odometry's poses
};

[[nodiscard]] ModelResult solve_se2(const Measurements& measurements, const PlacedAsrs& start,
                                    const CorrectOptions& options);
[[nodiscard]] ModelResult solve_rotation_only(const Measurements& measurements,
                                              const PlacedAsrs& start,
                                              const CorrectOptions& options);

}  // namespace roomatlas
