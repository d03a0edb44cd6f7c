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
  HeadingBias bias;  ///< of `odom_from_asr`; `driven` is already without it
};

/// What the walls say of the odometry's heading, see `smooth_headings`.
struct SmoothedHeadings {
  std::vector<double> correction_rad;  ///< to add to odometry's heading of each ASR
  double log_evidence = 0.0;           ///< of the walls' directions, given the bias
};

/// The heading correction of each ASR along the mission, from the directions of the rooms' walls,
/// which are known modulo 90 degrees: the posterior mean of a hidden Markov model with a state a
/// degree, forward and backward, unwrapped along the mission. Each component starts at 0; without
/// any walls all corrections are 0. A wall direction may be wrong (30 % uniform).
[[nodiscard]] SmoothedHeadings smooth_headings(const Measurements& measurements,
                                               const HeadingBias& bias,
                                               const CorrectOptions& options);

/// The heading bias with the greatest evidence, over a grid of 3.5 deg/m and 6 % of the turn, with
/// a weak prior at none. None for fewer than eight rectilinear ASRs.
[[nodiscard]] HeadingBias estimate_heading_bias(const Measurements& measurements,
                                                const CorrectOptions& options);

/// Takes a heading bias out of the driven edges. An ASR whose path was bent by the bias is placed
/// by its walls, whose direction it turned by half of what it turned the end of the path.
void remove_bias(Measurements& measurements, const HeadingBias& bias);

[[nodiscard]] Measurements measurements_of(const std::vector<Asr>& asrs, const RoomGraph& graph,
                                           const CorrectOptions& options);

/// Poses, and the direction of the walls of each component.
struct State {
  std::vector<Pose2> building_from_asr;
  std::vector<double> direction_rad;
};

/// Where to start: odometry from one ASR to the next, each turned as the smoothed headings say.
/// Without walls this is odometry. @param known where ASRs are known to be already; may be empty
[[nodiscard]] State initial_guess(const Measurements& measurements, const CorrectOptions& options,
                                  const Placement& known);

/// The angle to add to an ASR's heading to compare it with the building's direction: its walls'
/// direction plus as many quarter turns as lie between at `state`. Nothing where the ASR's walls
/// are farther off than the gate.
[[nodiscard]] std::optional<double> wall_offset(const Measurements& measurements,
                                                const State& state, std::size_t index,
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
  State state;
  bool converged = false;
  std::string message;
  double initial_cost = -1.0;  ///< as in `Correction`
  double final_cost = -1.0;    ///< as in `Correction`
  int iterations = 0;
  std::vector<FactorReport> factors;  ///< chi-square before is at odometry's poses
};

[[nodiscard]] ModelResult solve_se2(const Measurements& measurements, const State& start,
                                    const CorrectOptions& options);
[[nodiscard]] ModelResult solve_rotation_only(const Measurements& measurements, const State& start,
                                              const CorrectOptions& options);

}  // namespace roomatlas
