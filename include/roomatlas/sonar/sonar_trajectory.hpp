// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "roomatlas/core/pose2.hpp"
#include "roomatlas/mission/mission.hpp"
#include "roomatlas/odometry/drive_directions.hpp"
#include "roomatlas/odometry/habits.hpp"
#include "roomatlas/sonar/wall_segments.hpp"

namespace roomatlas {

struct SonarTrajectoryOptions {
  WallSegmentOptions segments;
  bool calibrate = true;         ///< off: odometry's habits are taken to be none
  bool repair_slips = true;      ///< tries headings turned by 90 degrees where they are unsure
  double verified_m = 10.0;      ///< of wall that several visits must have seen; less proves no
                                 ///< loop
  double verified_share = 0.06;  ///< contradiction above which loops count as not verified; doors,
                                 ///< people and wide cones leave 2 % of aces
  double verified_heading_share = 0.95;  ///< of readings with a sure heading; fewer verify nothing
  bool take_second = false;  ///< the second answer in the place of the first, where there is one
};

/// One setting of the batch that was tried.
struct SonarVariant {
  std::string name;
  OdometryHabits habits;
  std::size_t pairs = 0;        ///< of wall segments that were held to be one wall
  double compared_m = 0.0;      ///< of wall that another visit could confirm or contradict
  double contradiction = -1.0;  ///< share of it that others looked through, [0, 1]; negative =
                                ///< nothing could be compared
};

/// The best attempt that winds otherwise, where chance may have preferred the one kept.
struct SecondAnswer {
  std::string name;      ///< of its variant
  double score_m = 0.0;  ///< of wall that speaks for it
  double kept_m = 0.0;   ///< the same of the one kept, from the same tolerances
};

/// Other solutions, each laid on the one that is kept by least squares.
struct DrawnMoves {
  std::vector<std::vector<Pose2>> of_draw;  ///< of each draw, one a node: its pose in the frame of
                                            ///< the node's kept one; metres and radians are small
  std::vector<std::size_t> node_of;         ///< of each reading
};

/// The same mission solved by other means: where walls follow directions the map that was grown
/// from the beginning without any, else the best with directions.
struct CrossCheck {
  DrawnMoves moves;          ///< the one that it is from the one kept; none where there is none
  double merit_share = 0.0;  ///< how much better the kept one fits, over its score; negative: worse
};

/// The mission's poses, corrected by the walls that a ring of sonars heard.
struct SonarTrajectory {
  std::vector<Pose2> map_from_robot;  ///< one a reading; the first is odometry's first
  DrawnMoves drawn;                   ///< of all that walls and odometry leave open
  DrawnMoves wild;                    ///< of what they say against each other: see `draw_wild`
  DrawnMoves undirected;  ///< the one without the building's directions; none where it is kept
  CrossCheck cross_check;
  double followed_share = 1.0;      ///< of the walls that lie in directions of the map, see
                                    ///< `map_directions`, [0, 1]
  OdometryHabits habits;            ///< as found
  double length_scale_sigma = 0.0;  ///< of the habits' scale: posterior standard deviation, a share
                                    ///< of all lengths; 0.03 where no wall tells it
  double clutter_m = 0.0;  ///< how far stretches of one wall stand apart beyond their returns'
                           ///< scatter; over 0.02 what was heard were not walls alone
  std::optional<double> walls_rad;  ///< first of these directions in the map's frame, [-pi/4,
                                    ///< pi/4); none where walls follow no direction
  std::vector<double> wall_directions_rad;  ///< of the building, modulo 90 degrees, from the first
  double log_evidence = 0.0;                ///< of the headings, against "walls lie anyhow"
  int drives_reversed = 0;                  ///< that odometry reported the wrong way round
  double undecided_m = 0.0;                 ///< of path that could have gone either way
  std::size_t segments = 0;                 ///< stretches of wall
  double sure_heading_share = 0.0;  ///< of the readings: walls tell the heading to 5 degrees (one
                                    ///< standard deviation)
  std::vector<SonarVariant> variants;  ///< in the order tried
  std::size_t chosen = 0;              ///< place of the one kept
  double rival_score = 0.0;  ///< of the best attempt that winds otherwise, over that of the one
                             ///< kept; near 1 both explain the walls
  double attempts_apart_m = 0.0;       ///< how far attempts that do nearly as well end from the one
                                       ///< kept, the more the nearer their scores; root mean square
  double headings_apart_rad = 0.0;     ///< how far those with walls in directions that fit nearly
                                       ///< as well are turned against it; root mean square
  std::optional<SecondAnswer> second;  ///< that explains the readings nearly as well
  double strain = 0.0;     ///< of odometry by walls: half of its steps' robust squares, in sigmas
  int slips_repaired = 0;  ///< headings turned by 90 degrees from some place on
  bool loops_verified = false;  ///< false: no loop, or walls contradict each other
};

/// Corrects a whole mission recorded with sonars in one batch: the walls that single sonars hear
/// in consecutive readings give the heading modulo 90 degrees as a hidden Markov model over the
/// mission, odometry's habits are those that the model finds most likely, and poses and walls
/// are then solved together, which walls are one being decided anew while the tolerance shrinks.
///
/// Buildings without a common direction keep odometry's heading. What a mission does not revisit
/// is as good as odometry with the heading corrected. Deterministic; readings in file order, their
/// times need not ascend. An empty mission gives an empty trajectory; lasers are not used.
/// @param directions of the same readings, see `find_drive_directions`
/// @param before_attempt called in this thread before its batches, of which there are up to thirty;
///   to give up, it throws
/// @param jobs threads at once, see `for_each_index`. Slips that may be tried are tried ahead, so
///   that several threads may work more than one; what is chosen is what one would choose
/// @throws std::invalid_argument where there is not one direction a reading
[[nodiscard]] SonarTrajectory correct_sonar_trajectory(
    std::span<const RangeReading> readings, const DriveDirections& directions,
    const SonarTrajectoryOptions& options, const std::function<void()>& before_attempt = {},
    int jobs = 1);

}  // namespace roomatlas
