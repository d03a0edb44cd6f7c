// SPDX-License-Identifier: GPL-3.0-or-later
#include "free_map.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "map_directions.hpp"

namespace roomatlas {
namespace {

constexpr const char* kLoosened = "walls in any direction";
constexpr const char* kGrown = "walls in any direction, from the beginning on";
constexpr const char* kGrownAgain = "walls in any direction, with the habits of the whole";

// How a map grows: the first stretches teach odometry's habits, which keep what follows near. With
// smaller steps it takes longer and comes out alike; with larger ones more maps break.
constexpr double kFirstM = 5.0;       // of path, and what is added at least
constexpr double kSoon = 1.3;         // times what is solved already, ...
constexpr double kSoonUntilM = 60.0;  // ... until the habits are known, ...
constexpr double kLater = 1.6;        // ... and from then on
constexpr double kNearM = 1.0;        // how far a stretch comes out from its place, as a rule

constexpr double kMostFollow = 0.5;         // of the walls: with less, rooms radiate, ...
constexpr std::size_t kManyDirections = 9;  // ... each in its own direction

double next_end_m(double end_m) {
  return std::max(end_m * (end_m < kSoonUntilM ? kSoon : kLater), end_m + kFirstM);
}

DriveDirections beginning(DriveDirections directions, std::size_t count) {
  directions.of_step.resize(count);
  directions.undecided_m.resize(count);
  return directions;
}

/// Poses of the readings that are missing, as they were driven from the last one on.
void drive_on(const std::vector<Pose2>& driven, std::vector<Pose2>& poses) {
  for (std::size_t i = poses.size(); i < driven.size(); ++i) {
    poses.push_back(i == 0 ? driven[0] : poses[i - 1] * (inverse(driven[i - 1]) * driven[i]));
  }
}

/// Solves the beginning of a mission from where its own beginning was solved already.
void grow(const SonarMission& part, Idea& idea) {
  idea.problem.path = driven_path(part.readings, part.directions, idea.habits);
  drive_on(idea.problem.path.odom_from_robot, idea.attempt.map_from_robot);
  idea.attempt.directions_rad = idea.directions_rad;
  SonarBatchOptions options;
  options.start_scale_m = kNearM;
  idea.attempt = solve_again(part, idea, kGrown, options);
  if (part.options.calibrate) idea.habits = learnt_habits(part, idea);
}

/// The whole from odometry's own heading, with the habits that the whole taught.
void try_once_more(const SonarMission& mission, Idea& idea) {
  Idea again = idea;
  again.problem.path = driven_path(mission.readings, mission.directions, idea.habits);
  again.attempt.map_from_robot = again.problem.path.odom_from_robot;
  again.attempt.directions_rad = idea.directions_rad;
  again.attempt = solve_again(mission, again, kGrownAgain, {});
  if (merit(again.attempt) > merit(idea.attempt)) idea = std::move(again);
}

/// An idea whose heading is that of given poses.
Idea idea_at(const SonarMission& mission, const Calibration& calibration,
             const std::vector<double>& directions_rad, const std::vector<Pose2>& map_from_robot) {
  Idea idea = idea_of(mission, calibration, directions_rad);
  double before_rad = 0.0;
  for (std::size_t k = 0; k < idea.problem.node_readings.size(); ++k) {
    const std::size_t i = idea.problem.node_readings[k];
    const double off_rad =
        map_from_robot[i].theta_rad - idea.problem.path.odom_from_robot[i].theta_rad;
    before_rad += wrap_angle(off_rad - before_rad);
    idea.heading.correction_rad[k] = before_rad;
  }
  return idea;
}

Idea in_directions(const SonarMission& mission, const Idea& free, std::vector<double> walls_rad) {
  const double first_rad = walls_rad.front();
  for (double& wall_rad : walls_rad) wall_rad = wrap_quarter(wall_rad - first_rad);
  std::vector<Pose2> poses = free.attempt.map_from_robot;
  for (Pose2& pose : poses) pose = Pose2{0.0, 0.0, -first_rad} * pose;
  Idea idea = idea_at(mission, {free.habits, free.doubt}, walls_rad, poses);
  idea.is_open = true;
  if (mission.before_attempt) mission.before_attempt();
  idea.attempt = solve(mission, idea, "walls in the map's directions", idea.heading.correction_rad);
  return idea;
}

}  // namespace

Idea grown(const SonarMission& mission, const Calibration& calibration) {
  const std::size_t all = mission.readings.size();
  const auto path_m = driven_path(mission.readings, mission.directions, {}).path_m;
  Idea idea;
  idea.is_free = true;
  idea.directions_rad = {0.0};
  idea.habits = calibration.habits;
  idea.doubt = calibration.doubt;
  std::size_t count = 0;
  for (double end_m = kFirstM; count < all; end_m = next_end_m(end_m)) {
    const auto end = std::upper_bound(path_m.begin(), path_m.end(), end_m);
    const bool is_last = next_end_m(end_m) > path_m.back();  // what is left is too little alone
    count = is_last ? all : static_cast<std::size_t>(end - path_m.begin());
    const DriveDirections directions = beginning(mission.directions, count);
    grow({mission.readings.first(count), directions, mission.options, mission.before_attempt,
          mission.jobs},
         idea);
  }
  try_once_more(mission, idea);
  Idea whole = idea_at(mission, {idea.habits, idea.doubt}, {0.0}, idea.attempt.map_from_robot);
  whole.is_free = true;
  whole.attempt = std::move(idea.attempt);
  whole.attempt.correction_rad = whole.heading.correction_rad;
  whole.attempt.variant.habits = whole.habits;
  return whole;
}

Idea loosened(const SonarMission& mission, const Idea& idea) {
  Idea loose = idea;
  loose.is_free = true;
  loose.attempt = solve(mission, loose, kLoosened, loose.heading.correction_rad);
  return loose;
}

Idea undirected(const SonarMission& mission, const Idea& idea) {
  SonarBatchOptions options = from_there();
  options.heading_weight = 0.0;
  Idea loose = idea;
  loose.attempt = solve_again(mission, idea, "walls in any direction from there", options);
  return loose;
}

std::vector<MapWall> walls_on(const Idea& idea) {
  std::vector<MapWall> walls;
  walls.reserve(idea.problem.segments.size());
  for (const WallSegment& segment : idea.problem.segments) {
    const double heading_rad = idea.attempt.map_from_robot[segment.reading].theta_rad;
    walls.push_back({heading_rad + segment.normal_rad, segment.length_m});
  }
  return walls;
}

Idea directed(const SonarMission& mission, const Idea& free, const std::vector<double>& walls_rad) {
  Idea few = in_directions(mission, free, walls_rad);
  if (free.followed_share >= kMostFollow) return few;
  MapDirectionsOptions options;
  options.most = kManyDirections;
  const std::vector<double> many_rad = map_directions(walls_on(free), options);
  if (many_rad.size() <= walls_rad.size()) return few;
  Idea many = in_directions(mission, free, many_rad);
  return merit(many.attempt) > merit(few.attempt) ? many : few;
}

}  // namespace roomatlas
