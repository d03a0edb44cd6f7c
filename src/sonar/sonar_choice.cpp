// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_choice.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "free_map.hpp"

namespace roomatlas {
namespace {

/// A change of odometry's habits, of about what the calibration's steps leave open. Where little is
/// heard, the batch ends elsewhere from each.
struct Change {
  const char* name;
  double bias_deg_per_m;
  double turn_gain;
};
constexpr Change kChanges[] = {
    {"bias +0.25 deg/m, gain -0.01", 0.25, -0.01},
    {"bias -0.25 deg/m, gain +0.01", -0.25, 0.01},
    {"bias +0.25 deg/m, gain -0.03", 0.25, -0.03},
    {"bias -0.25 deg/m, gain +0.03", -0.25, 0.03},
    {"gain -0.03", 0.0, -0.03},
    {"gain +0.03", 0.0, 0.03},
};

// Of directions that are found once the whole is solved.
constexpr double kWingsApart =
    radians(6.0);                    // that a wing must be; headings wander as far without any
constexpr double kStrainLeft = 0.9;  // of odometry's, at most

constexpr const char* kOdometrysOwn = "odometry's own heading";

/// Whether the walls make one heading clearly more likely than walls that lie anyhow would: in a
/// round hall they do not.
bool walls_follow_directions(const HeadingProblem& problem,
                             const std::vector<double>& directions_rad,
                             const SightingChainOptions& chain) {
  constexpr double kLeastASegment = 0.05;  // of log evidence; more takes the directions from short
                                           // missions in cluttered rooms
  const double evidence = heading_evidence(problem.nodes, problem.sightings, directions_rad, chain);
  return !problem.sightings.empty() &&
         evidence > kLeastASegment * static_cast<double>(problem.sightings.size());
}

std::string name_of(const std::vector<double>& walls_rad) {
  if (walls_rad.size() == 1) return "walls in one direction";
  return "walls in " + std::to_string(walls_rad.size()) + " directions";
}

/// An idea to be worked out and solved.
struct Consideration {
  std::string name;
  Calibration calibration;
  std::vector<double> directions_rad;
  bool is_odometry = false;
  bool is_open = false;
};

Idea solved(const SonarMission& mission, const Consideration& one) {
  Idea idea = idea_of(mission, one.calibration, one.directions_rad);
  if (one.is_odometry) {
    std::fill(idea.heading.correction_rad.begin(), idea.heading.correction_rad.end(), 0.0);
    idea.is_odometry = true;
  }
  idea.is_open = one.is_open;
  idea.attempt = solve(mission, idea, one.name, idea.heading.correction_rad);
  return idea;
}

constexpr double kPerhaps = 2.0;  // of log evidence for another direction of the building

Idea anew(const SonarMission& mission, Idea idea) {
  if (mission.before_attempt) mission.before_attempt();
  idea.attempt = solve_again(mission, idea, "walls extracted anew", from_there());
  return idea;
}

/// Whether a free map is better than the best, as tried and with the walls of both extracted anew:
/// a map that grew has them from its own poses already, and they agree the better for it.
bool is_answer(const SonarMission& mission, const Idea& free, const Idea& best) {
  return takes_over(free, best) && takes_over(anew(mission, free), anew(mission, best));
}

bool has_wing(const std::vector<double>& walls_rad) {
  return std::any_of(walls_rad.begin(), walls_rad.end(), [&](double wall_rad) {
    return std::abs(wrap_quarter(wall_rad - walls_rad.front())) > kWingsApart;
  });
}

std::size_t place_of(const std::string& name, const std::vector<SonarVariant>& variants) {
  const auto found = std::find_if(variants.begin(), variants.end(),
                                  [&](const SonarVariant& one) { return one.name == name; });
  return static_cast<std::size_t>(found - variants.begin());
}

}  // namespace

void Choice::offer(Idea idea, SonarTrajectory& result) {
  result.variants.push_back(idea.attempt.variant);
  if (best && !takes_over(idea, *best)) {
    set_aside(std::move(idea.attempt), others);
    return;
  }
  if (best) set_aside(std::move(best->attempt), others);
  result.chosen = result.variants.size() - 1;
  best = std::move(idea);
}

Start choose_heading(const SonarMission& mission, const Calibration& likely,
                     SonarTrajectory& result) {
  const HeadingProblem problem = heading_problem(
      mission.readings, mission.directions, likely.habits, mission.options.segments, mission.jobs);
  const SightingChainOptions chain = likely.doubting({});
  const std::vector<double> walls_rad = building_directions(problem, chain, kClearly, mission.jobs);
  std::vector<Consideration> all;
  if (walls_follow_directions(problem, walls_rad, chain)) {
    // all of them first: wings at an angle are believed
    if (walls_rad.size() > 1) all.push_back({name_of(walls_rad), likely, walls_rad, false, false});
    all.push_back({name_of({0.0}), likely, {0.0}, false, false});
    // a wing that was seldom entered says little of its angle: the batch decides
    const auto open_rad = building_directions(problem, chain, kPerhaps, mission.jobs);
    if (open_rad.size() > walls_rad.size()) {
      all.push_back({name_of(open_rad), likely, open_rad, false, true});
    }
  }
  all.push_back({kOdometrysOwn, {}, {0.0}, true, false});
  std::vector<Idea> ideas =
      tried<Idea>(mission, 1 + all.size(), [&](const SonarMission& alone, std::size_t i) {
        return i == 0 ? grown(alone, likely) : solved(alone, all[i - 1]);  // the longest first
      });
  Start start{{}, std::move(ideas.front())};
  for (std::size_t i = 1; i < ideas.size(); ++i) start.choice.offer(std::move(ideas[i]), result);
  return start;
}

void consider_free_map(const SonarMission& mission, Idea from_beginning, Choice& choice,
                       SonarTrajectory& result) {
  Idea free = std::move(from_beginning);
  if (!choice.best->is_odometry) {
    if (mission.before_attempt) mission.before_attempt();
    Idea loose = loosened(mission, *choice.best);
    if (merit(loose.attempt) >= merit(free.attempt)) std::swap(loose, free);
    result.variants.push_back(loose.attempt.variant);  // no other winding
  }
  bool is_kept = false;
  if (merit(free.attempt) > merit(choice.best->attempt)) {
    const std::vector<MapWall> walls = walls_on(free);
    if (!walls.empty()) {
      const std::vector<double> walls_rad = map_directions(walls);
      free.followed_share = followed_share(walls, walls_rad);
      Idea held = directed(mission, free, walls_rad);
      is_kept = takes_over(free, held);
      choice.offer(std::move(held), result);
    }
  }
  if (is_kept && is_answer(mission, free, *choice.best)) {
    choice.offer(std::move(free), result);
  } else {
    result.variants.push_back(free.attempt.variant);
    set_aside(std::move(free.attempt), choice.others);
  }
}

void consider_other_habits(const SonarMission& mission, const Calibration& likely, Choice& choice,
                           SonarTrajectory& result) {
  std::vector<Consideration> all;
  for (const Change& change : kChanges) {
    Calibration changed = likely;
    changed.habits.bias_rad_per_m += radians(change.bias_deg_per_m);
    changed.habits.turn_gain += change.turn_gain;
    all.push_back({change.name, changed, choice.best->directions_rad, false, false});
  }
  for (Idea& idea : tried<Idea>(mission, all.size(), [&](const SonarMission&alone, std::size_t i) {
         return solved(alone, all[i]);
       })) {
    choice.offer(std::move(idea), result);
  }
}

Idea reconsider_directions(const SonarMission& mission, Choice& choice, SonarTrajectory& result) {
  if (mission.before_attempt) mission.before_attempt();
  Idea loose = undirected(mission, *choice.best);
  const std::vector<MapWall> walls = walls_on(loose);
  const std::vector<double> walls_rad = map_directions(walls);
  if (walls_rad.size() <= choice.best->directions_rad.size() || !has_wing(walls_rad)) return loose;
  loose.followed_share = followed_share(walls, walls_rad);
  Idea held = directed(mission, loose, walls_rad);
  Attempt again = solve_again(mission, held, "walls in the map's directions anew", from_there());
  if (merit(again) > merit(held.attempt)) held.attempt = std::move(again);
  result.variants.push_back(held.attempt.variant);
  if (merit(held.attempt) <= merit(choice.best->attempt) ||
      held.attempt.strain > kStrainLeft * choice.best->attempt.strain) {
    set_aside(std::move(held.attempt), choice.others);
    return loose;
  }
  set_aside(std::move(choice.best->attempt), choice.others);
  result.chosen = result.variants.size() - 1;
  choice.best = std::move(held);
  return undirected(mission, *choice.best);
}

void take(const SonarMission& mission, std::size_t other, Choice& choice, SonarTrajectory& result) {
  std::swap(choice.best->attempt, choice.others[other]);
  const SonarVariant& taken = choice.best->attempt.variant;
  result.chosen = place_of(taken.name, result.variants);
  choice.best->habits = taken.habits;
  choice.best->problem.path = driven_path(mission.readings, mission.directions, taken.habits);
  choice.best->is_odometry = choice.best->attempt.is_odometry;
  choice.best->is_free = choice.best->attempt.is_free;
}

}  // namespace roomatlas
