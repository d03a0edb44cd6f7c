// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/asr/asr.hpp"
#include "roomatlas/odometry/habits.hpp"

#include <optional>
#include <string>
#include <vector>

namespace roomatlas {

/// What a measurement between ASRs came from.
enum class FactorKind {
  odometry,        ///< the robot drove from one into the next
  doorway,         ///< the same doorway seen again: a pivot shared by two visits
  closure,         ///< two visits saw the same walls
  wall_direction,  ///< the walls of a rectilinear room follow the building's direction
};

[[nodiscard]] const char* to_string(FactorKind kind);

/// One measurement and what the correction made of it.
struct FactorReport {
  FactorKind kind = FactorKind::odometry;
  AsrId from = 0;
  AsrId to = 0;                     ///< 0 for a factor on one ASR alone
  double chi_square_before = -1.0;  ///< at the uncorrected poses; negative: not computed
  double chi_square_after = -1.0;   ///< at the corrected poses; the same
  double weight = 0.0;  ///< of the robust loss at the solution, [0, 1]; near 0: rejected
};

/// Where one ASR was and where it is now, in building metres.
struct AsrCorrection {
  AsrId asr = 0;
  std::int64_t component = 0;      ///< connected component of the graph; each has one fixed ASR
  Pose2 building_from_asr_before;  ///< as odometry placed it
  Pose2 building_from_asr;         ///< corrected
  double moved_m = 0.0;            ///< distance between the two origins
  double turned_rad = 0.0;         ///< [-pi, pi)
  /// Of the measurements that touch this ASR, the sum before and after ...
  double chi_square_before = 0.0;
  double chi_square_after = 0.0;
  /// ... and the one that the correction settled most: why the ASR moved. Nothing where none got
  /// better.
  std::optional<FactorKind> cause = std::nullopt;
  AsrId cause_asr = 0;  ///< on the other side of it; 0 for a wall direction
};

/// Odometry's habits as the walls of a mission's rooms show them: bias and gain of turns alone.
struct EstimatedHabits {
  OdometryHabits habits;
  int asrs = 0;  ///< with walls, that they were estimated from; 0: not estimated, and none
};

/// The result of the offline correction, fit to be judged. Starts in a state that cannot pass
/// for success.
struct Correction {
  bool converged = false;
  std::string model;           ///< "se2", "rotation_only", "trajectory" (a mission of sonars) or
                               ///< "joined" (several missions)
  std::string message;         ///< why the solver stopped
  double initial_cost = -1.0;  ///< half of the robust squares at the start; negative: not solved
  double final_cost = -1.0;    ///< the same at the end
  int iterations = 0;
  EstimatedHabits odometry;
  std::vector<AsrCorrection> asrs;    ///< ascending by ASR
  std::vector<FactorReport> factors;  ///< in the order in which they were added
};

}  // namespace roomatlas
