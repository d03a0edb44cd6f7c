// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_repairs.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "heading_slips.hpp"

namespace roomatlas {
namespace {

/// The posterior's mean given that the heading went the other way: smoothed about a heading that
/// has gone there already.
std::vector<double> slipped(const Idea& idea, const HeadingSlip& slip) {
  std::vector<double> prior_rad = idea.attempt.correction_rad;
  for (std::size_t k = slip.first_node; k < prior_rad.size(); ++k) {
    const std::size_t at = std::min(k - slip.first_node, slip.more_rad.size() - 1);
    prior_rad[k] += slip.more_rad[at];
  }
  std::vector<WallSighting> sightings = idea.problem.sightings;
  for (WallSighting& wall : sightings) {
    wall.direction_rad = wrap_angle(wall.direction_rad + prior_rad[wall.node]);
  }
  const MissionHeading smoothed =
      mission_heading(idea.problem.nodes, sightings, idea.directions_rad, idea.chain_options);
  for (std::size_t k = 0; k < prior_rad.size(); ++k) {
    prior_rad[k] += smoothed.correction_rad[k];
  }
  return prior_rad;
}

HeadingSlip undone(HeadingSlip slip) {
  for (double& more : slip.more_rad) more = -more;
  return slip;
}

std::string name_of(const HeadingSlip& slip, const Idea& idea) {
  const double quarter = degrees(slip.more_rad.back());
  const auto at_m = std::lround(idea.problem.nodes[slip.first_node].path_m);
  return "turned by " + std::to_string(std::lround(quarter)) + " deg from " + std::to_string(at_m) +
         " m on, log odds " + std::to_string(std::lround(slip.log_odds));
}

/// The idea with other habits where its own were far off: those of a short mission, or of a heading
/// that slipped.
Idea with_learnt_habits(const SonarMission& mission, const Idea& idea) {
  constexpr double kFarBias = radians(0.5);  // a metre; nearer, both are what the walls leave open
  constexpr double kFarGain = 0.03;
  const OdometryHabits habits = learnt_habits(mission, idea);
  Idea learnt = idea;
  if (std::abs(habits.bias_rad_per_m - idea.habits.bias_rad_per_m) > kFarBias ||
      std::abs(habits.turn_gain - idea.habits.turn_gain) > kFarGain) {
    learnt.habits = habits;
    learnt.problem.path = driven_path(mission.readings, mission.directions, habits);
  }
  return learnt;
}

}  // namespace

void repair_slips(const SonarMission& mission, Idea& idea, std::vector<Attempt>& others,
                  SonarTrajectory& result) {
  constexpr double kLeastLogOdds = -60.0;  // of slips that are tried; the walls rule out the rest
  constexpr std::size_t kMostTries = 16;   // batches: time alone
  std::size_t tries = 0;
  std::vector<HeadingSlip> refuted;
  const auto is_refuted = [&](const HeadingSlip& slip) {
    return std::any_of(refuted.begin(), refuted.end(),
                       [&](const HeadingSlip& other) { return are_one(slip, other); });
  };
  for (bool repaired = true; repaired;) {
    repaired = false;
    std::vector<HeadingSlip> slips =
        find_slips(idea.problem.nodes, idea.problem.sightings, idea.directions_rad,
                   idea.chain_options, idea.attempt.correction_rad, kLeastLogOdds);
    std::erase_if(slips, is_refuted);  // no two of the others are one
    for (std::size_t next = 0; next < slips.size() && !repaired;) {
      if (tries == kMostTries) return;
      const std::size_t count =
          std::min({thread_count(mission.jobs), slips.size() - next, kMostTries - tries});
      auto attempts = tried<Attempt>(mission, count, [&](const SonarMission& alone, std::size_t i) {
        const HeadingSlip& slip = slips[next + i];
        return solve(alone, idea, name_of(slip, idea), slipped(idea, slip));
      });
      for (std::size_t i = 0; i < count && !repaired; ++i, ++next, ++tries) {
        result.variants.push_back(attempts[i].variant);
        repaired = is_better(attempts[i], idea.attempt);
        if (repaired) {
          std::swap(attempts[i], idea.attempt);
          result.chosen = result.variants.size() - 1;
          ++result.slips_repaired;
        }
        set_aside(std::move(attempts[i]), others);
        refuted.push_back(repaired ? undone(slips[next]) : slips[next]);
      }
    }
  }
}

void refine(const SonarMission& mission, Idea& idea, SonarTrajectory& result) {
  const auto offer = [&](Attempt attempt) {
    result.variants.push_back(attempt.variant);
    if (merit(attempt) <= merit(idea.attempt)) return false;
    result.chosen = result.variants.size() - 1;
    idea.attempt = std::move(attempt);
    return true;
  };
  const std::vector<double> heading_rad = idea.attempt.correction_rad;
  SonarBatchOptions wide;
  wide.start_scale_m = 2.0;  // a corridor's width: more takes its sides for one wall
  for (Attempt& attempt : tried<Attempt>(mission, 2, [&](const SonarMission&alone, std::size_t i) {
         return i == 0 ? solve(alone, idea, "from 2 m", heading_rad, wide)
                       : solve(alone, idea, "from 0.5 m", heading_rad, from_there());
       })) {
    (void)offer(std::move(attempt));
  }
  constexpr int kMostTimes = 2;  // time alone
  for (int times = 0; times < kMostTimes; ++times) {
    if (mission.before_attempt) mission.before_attempt();
    Idea learnt = with_learnt_habits(mission, idea);
    if (!offer(solve_again(mission, learnt, "walls extracted anew", from_there()))) {
      break;
    }
    learnt.attempt = std::move(idea.attempt);
    idea = std::move(learnt);
  }
}

}  // namespace roomatlas
