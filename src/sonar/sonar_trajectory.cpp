// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/sonar/sonar_trajectory.hpp"

#include <stdexcept>
#include <utility>

#include "free_map.hpp"
#include "sonar_attempt.hpp"
#include "sonar_choice.hpp"
#include "sonar_repairs.hpp"
#include "sonar_rivals.hpp"

namespace roomatlas {
namespace {

/// Moves a trajectory so that it begins where odometry does. @return the turn
double begin_at(const Pose2& first, std::vector<Pose2>& poses) {
  const Pose2 moved = first * inverse(poses.front());
  for (Pose2& pose : poses) pose = moved * pose;
  return moved.theta_rad;
}

/// What the idea that is kept tells of itself, and what the others tell of it.
void tell(const Choice& choice, const SonarTrajectoryOptions& options, SonarTrajectory& result) {
  const Idea& best = *choice.best;
  const Attempt& kept = best.attempt;
  result.habits = best.habits;
  result.length_scale_sigma = kept.length_scale_sigma;
  result.clutter_m = kept.clutter_m;
  result.wall_directions_rad = kept.directions_rad;
  result.log_evidence = best.heading.log_evidence;
  result.segments = best.problem.segments.size();
  result.sure_heading_share = share_with_sure_heading(best);
  result.strain = kept.strain;
  const std::vector<MapWall> walls = walls_on(best);
  if (!walls.empty()) result.followed_share = followed_share(walls, map_directions(walls));
  result.rival_score = rival_score(kept, choice.others);
  result.attempts_apart_m = attempts_apart(kept, choice.others);
  result.headings_apart_rad = headings_apart(kept, choice.others);
  result.loops_verified = is_verified(best, choice.others, options);
}

}  // namespace

SonarTrajectory correct_sonar_trajectory(std::span<const RangeReading> readings,
                                         const DriveDirections& directions,
                                         const SonarTrajectoryOptions& options,
                                         const std::function<void()>& before_attempt, int jobs) {
  if (directions.of_step.size() != readings.size()) {
    throw std::invalid_argument("correct_sonar_trajectory: not one direction of drive a reading");
  }
  SonarTrajectory result;
  if (readings.empty()) return result;
  result.drives_reversed = directions.drives_reversed;
  result.undecided_m = directions.undecided_m.back();
  Calibration likely;
  if (options.calibrate) {
    likely = calibrate_odometry(readings, directions, options.segments, {}, jobs);
  }
  const SonarMission mission{readings, directions, options, before_attempt, jobs};
  auto [choice, from_beginning] = choose_heading(mission, likely, result);
  const Attempt grown_alone = from_beginning.attempt;
  consider_free_map(mission, std::move(from_beginning), choice, result);
  const bool follows_walls = choice.best->follows_directions();
  if (options.calibrate && follows_walls && !is_verified(*choice.best, choice.others, options)) {
    consider_other_habits(mission, likely, choice, result);
  }
  Idea& best = *choice.best;
  if (options.repair_slips && follows_walls) {
    repair_slips(mission, best, choice.others, result);
  }
  const Attempt* second = second_answer(readings, best.attempt, choice.others);
  if (second != nullptr) {
    result.second = SecondAnswer{second->variant.name, second->score_m, best.attempt.score_m};
  }
  if (options.take_second && second != nullptr) {
    take(mission, static_cast<std::size_t>(second - choice.others.data()), choice, result);
  } else {
    refine(mission, best, result);
    if (follows_walls) {
      Idea loose = reconsider_directions(mission, choice, result);
      result.undirected =
          moves_of_readings(std::move(loose.attempt.map_from_robot), best.attempt.map_from_robot);
    }
  }
  tell(choice, options, result);
  result.cross_check = cross_checked(best.attempt, grown_alone, choice.others);
  if (before_attempt) before_attempt();
  Sharpened sharpened = with_returns(mission, best);
  result.drawn = std::move(sharpened.drawn);
  result.wild = std::move(sharpened.wild);
  result.map_from_robot = std::move(sharpened.map_from_robot);
  result.habits.length_scale *= sharpened.length_scale;
  const double turn_rad = begin_at(readings.front().odom_from_robot, result.map_from_robot);
  if (best.follows_directions()) result.walls_rad = wrap_quarter(turn_rad);
  return result;
}

}  // namespace roomatlas
