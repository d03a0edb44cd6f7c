// SPDX-License-Identifier: GPL-3.0-or-later
// One way to solve a mission with sonars: a heading, poses and walls in one batch, and a score by
// what the visits say of each other's walls.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "mission_heading.hpp"
#include "roomatlas/core/for_each_index.hpp"
#include "roomatlas/sonar/contradiction.hpp"
#include "roomatlas/sonar/sonar_trajectory.hpp"
#include "sonar_batch.hpp"
#include "sonar_calibration.hpp"
#include "sonar_problem.hpp"

namespace roomatlas {

/// What is corrected, and how.
struct SonarMission {
  std::span<const RangeReading> readings;
  const DriveDirections& directions;
  const SonarTrajectoryOptions& options;
  const std::function<void()>& before_attempt;  ///< may be empty; what it throws ends the work
  int jobs = 1;                                 ///< threads at once, see `for_each_index`

  /// The same in one thread: for work that is done beside other work.
  [[nodiscard]] SonarMission alone() const {
    return {readings, directions, options, before_attempt, 1};
  }
};

/// The results of independent attempts, as many at once as the mission has jobs; `make(alone, i)`
/// takes the mission in one thread.
template <typename Result, typename Make>
[[nodiscard]] std::vector<Result> tried(const SonarMission& mission, std::size_t count,
                                        const Make& make) {
  const SonarMission alone = mission.alone();
  const SonarMission& used = count > 1 ? alone : mission;
  return results_of<Result>(
      count, mission.jobs, [&](std::size_t i) { return make(used, i); },
      [&](std::size_t) {
        if (mission.before_attempt) mission.before_attempt();
      });
}

/// A trajectory, and what its visits say of each other's walls.
struct Attempt {
  std::vector<double> correction_rad;  ///< of the heading, by node of the chain
  std::vector<Pose2> map_from_robot;
  std::vector<double> directions_rad;  ///< of the building's walls, as the batch found them
  double length_scale = 1.0;           ///< times what the heading's habits make of lengths
  double length_scale_sigma = 0.0;
  double clutter_m = 0.0;
  SonarVariant variant;
  double score_m = 0.0;  ///< of wall: confirmed, less what is contradicted; of a batch that could
                         ///< not be solved the lowest there is
  std::vector<double> score_of_reading_m;  ///< what of it is of the walls that each reading heard
  double strain = 0.0;                     ///< of odometry
  bool is_odometry = false;                ///< as its idea's
  bool is_free = false;                    ///< as its idea's

  [[nodiscard]] bool follows_directions() const { return !is_odometry && !is_free; }
};

/// Keeps it beside the best, without what only the best needs.
void set_aside(Attempt attempt, std::vector<Attempt>& others);

/// Metres of wall: confirmed, less three times what is contradicted.
[[nodiscard]] double score_of(const Contradiction& contradiction);

/// By more than noise.
[[nodiscard]] bool is_better(const Attempt& attempt, const Attempt& than);

/// Of attempts with like headings. Walls of two rooms that are held to be one confirm each other,
/// but bend odometry: a metre of wall counts as much as one of log likelihood.
[[nodiscard]] double merit(const Attempt& attempt);

/// Habits, the heading that they make likely, and what came of it.
struct Idea {
  OdometryHabits habits;
  double doubt = 1.0;
  bool is_odometry = false;  ///< the heading is odometry's, and walls follow no direction
  bool is_open = false;      ///< the heading's chain leaves its directions open
  bool is_free = false;      ///< walls follow no direction; those of the idea are not used
  double followed_share =
      1.0;  ///< of the walls, if it is free: they follow directions all the same
  SightingChainOptions chain_options;
  std::vector<double> directions_rad;  ///< of the building's walls
  HeadingProblem problem;
  MissionHeading heading;
  Attempt attempt;

  /// Of the building, with its walls.
  [[nodiscard]] bool follows_directions() const { return !is_odometry && !is_free; }
};

/// Of walls that lie anyhow, as many lie within 5 degrees of one of three directions. Where no more
/// do on a free map, the building has none that it could be held to: 0.16 to 0.58 where rooms
/// radiate, 0.51 to 0.93 elsewhere.
constexpr double kByChance = 1.0 / 3.0;

/// Whether an idea takes the place of the best so far: by a better score and merit. Odometry's own
/// heading must make up for all that walls say for a direction, too: it fits a few more of them by
/// bending corridors. More directions than the best has, where the chain leaves them open, must
/// take a quarter of odometry's strain, whatever the score, and as many need be no more than
/// better. Walls that follow none leave odometry so much room that it must fit far better, unless
/// no more of them follow directions on that map than would by chance.
[[nodiscard]] bool takes_over(const Idea& idea, const Idea& best);

[[nodiscard]] Idea idea_of(const SonarMission& mission, const Calibration& calibration,
                           const std::vector<double>& directions_rad);

/// The idea's habits with bias and gain as odometry has them against the poses that its walls gave.
[[nodiscard]] OdometryHabits learnt_habits(const SonarMission& mission, const Idea& idea);

/// Solves an idea with one heading, whatever its own attempt was. Wall that is contradicted counts
/// three times in the score.
/// @param name of the variant
[[nodiscard]] Attempt solve(const SonarMission& mission, const Idea& idea, std::string name,
                            std::vector<double> correction_rad,
                            SonarBatchOptions batch_options = {});

/// Of a batch that goes on from where another ended: it looks nearer than the wall of the room next
/// door.
[[nodiscard]] inline SonarBatchOptions from_there() {
  SonarBatchOptions options;
  options.start_scale_m = 0.5;
  return options;
}

/// Solves once more from where the idea's attempt ended: the walls are extracted anew at its poses,
/// and are the sharper the truer these are.
[[nodiscard]] Attempt solve_again(const SonarMission& mission, const Idea& idea, std::string name,
                                  const SonarBatchOptions& batch_options);

/// Poses of which single returns are a part, beside the stretches of wall that they make.
struct Sharpened {
  std::vector<Pose2> map_from_robot;
  double length_scale = 1.0;  ///< as the attempt's
  DrawnMoves drawn;           ///< of them, see `SonarTrajectory`; none where the batch had no
  DrawnMoves wild;            ///< solution
};

/// Solves once more from where the idea's attempt ended, with single returns: each is held against
/// walls that other visits saw. They say most where few stretches were heard: with three to seven
/// sonars.
[[nodiscard]] Sharpened with_returns(const SonarMission& mission, const Idea& idea);

/// The chain's values by node as values by reading, those between nodes by way and turn.
[[nodiscard]] std::vector<double> by_reading(const HeadingProblem& problem,
                                             const std::vector<double>& by_node);

}  // namespace roomatlas
