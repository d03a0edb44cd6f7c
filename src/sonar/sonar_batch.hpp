// SPDX-License-Identifier: GPL-3.0-or-later
// Poses of a mission and the walls seen from them, in one least-squares problem.
#pragma once

#include <vector>

#include "return_matches.hpp"
#include "roomatlas/core/pose2.hpp"
#include "roomatlas/sonar/sonar_trajectory.hpp"
#include "wall_pairs.hpp"

namespace roomatlas {

/// From the node before to a node, as driven, with standard deviations.
struct DrivenStep {
  Pose2 before_from_here;
  double along_sigma_m = 0.0;
  double across_sigma_m = 0.0;
  double turn_sigma_rad = 0.0;
};

struct SonarBatch {
  std::vector<Pose2> map_from_node;  ///< where to start
  std::vector<DrivenStep> steps;     ///< one a node; the first is not used
  std::vector<SeenWall> walls;
  std::vector<SeenReturn> returns;  ///< taken once it is known which walls are one; may be none
  std::vector<double> directions_rad = {0.0};  ///< of the building's walls, modulo 90 degrees; the
                                               ///< first is the frame's and stays
};

struct SonarBatchOptions {
  bool is_settled = false;  ///< the poses are those of an earlier solution: the last rounds alone,
                            ///< and moves are drawn of what they leave open
  WallPairOptions pairs;
  double start_scale_m = 1.5;       ///< smaller misses loops that are farther apart
  double end_scale_m = 0.1;         ///< smaller lets noise decide which walls are one
  double wall_sigma_m = 0.05;       ///< of one wall against all its partners; smaller lets it bend
                                    ///< odometry by its noise
  double start_wall_weight = 0.3;   ///< of a wall's partners together, in the first round (with the
                                    ///< last's, excursions are taken by the next room's wall) ...
  double wall_weight = 3.0;         ///< ... and in the last
  double step_robust_sigmas = 3.0;  ///< Cauchy's loss of odometry; larger does not give way where
                                    ///< it jumped, smaller lets walls break it
  double heading_weight = 0.5;   ///< of a wall that follows the building: the segments of one wall
                                 ///< say the same, so that each counts half
  double parallel_weight = 0.3;  ///< of the partners' headings, for the same reason
  double start_length_sigma = 0.003;  ///< of odometry's lengths as a whole, as a share, until it is
                                      ///< known which walls are one: larger lets them draw together
  double length_sigma = 0.03;  ///< and from then on, as recorded and drawn odometry has it ...
  double clutter_m = 0.01;  ///< ... at so much clutter or less, and smaller by its square beyond:
                            ///< cones full of clutter make rooms look smaller
  double return_sigma_m = 0.025;     ///< of a return's range and of where its walls are
  double return_share = 0.4;         ///< of all sonars' returns together: what one would say alone;
                                     ///< they hear the same walls, a step apart
  double direction_sigma_rad = 0.1;  ///< of the building's directions but the first: as far as they
                                     ///< are found beside the true ones, and more
  double wall_heading_rad = 0.035;   ///< sigma of a wall's direction, and one over its length more;
                                     ///< less draws false directions in while the true are sought
  double settled_heading_weight = 1.0;        ///< in the place of `heading_weight` at the solution
  double settled_heading_rad = radians(0.6);  ///< sigma of a wall's direction there, however long
                                              ///< it is, ...
  double settled_scatter = 2.0;  ///< ... and its returns' scatter over its length to the power of
                                 ///< 3/2 times this, in sqrt(m): 2.6 times what a line through
                                 ///< points 5 cm apart turns by
};

struct SonarBatchResult {
  std::vector<Pose2> map_from_node;
  std::vector<std::vector<Pose2>> moves;  ///< see `DrawnMoves`; none where it was not solved, or
                                          ///< not settled before
  std::vector<std::vector<Pose2>> wild;   ///< the same
  std::vector<double> directions_rad;     ///< of the building, as the walls and odometry have them
  double length_scale = 1.0;              ///< times odometry's lengths: what the walls make of them
  double length_scale_sigma = 0.0;  ///< its posterior standard deviation; near the prior's, walls
                                    ///< said nothing of it
  double clutter_m =
      0.0;                ///< what pairs are apart beyond their returns' scatter, in the last round
  double strain = 0.0;    ///< of odometry: half of its steps' robust squares, in sigmas
  std::size_t pairs = 0;  ///< in the last round
  bool solved = false;    ///< false: a system was singular, and the poses are those before it
};

/// How far stretches of one wall stand apart beyond what the scatter of their returns explains:
/// what was heard were not walls alone. Root mean square, metres; 0 without pairs.
[[nodiscard]] double clutter_of(const std::vector<SeenWall>& walls,
                                const std::vector<WallPair>& pairs,
                                const std::vector<Pose2>& map_from_node);

[[nodiscard]] SonarBatchResult solve_sonar_batch(const SonarBatch& batch,
                                                 const SonarBatchOptions& options);

}  // namespace roomatlas
