// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_repairs.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "heading_slips.hpp"

namespace roomatlas {
namespace {

using Readings = std::span<const RangeReading>;

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
  const HeadingChain chain =
      smooth_heading(idea.problem.nodes, sightings, idea.directions_rad, idea.chain_options);
  for (std::size_t k = 0; k < prior_rad.size(); ++k) {
    prior_rad[k] += chain.correction_rad[k];
  }
  return prior_rad;
}

/// Slips of the heading that a freer odometry would allow, the likeliest first.
std::vector<HeadingSlip> possible_slips(const Idea& idea) {
  constexpr double kLeastShare = 0.01;
  constexpr std::size_t kMost = 12;
  constexpr double kFreer = 2.5;
  HeadingChainOptions loose = idea.chain_options;
  loose.trust /= 2.0;
  loose.drift_rad_per_sqrt_m *= kFreer;
  loose.drift_per_turn *= kFreer;
  std::vector<HeadingSlip> slips;
  for (HeadingSlip& slip : find_slips(idea.problem.nodes, idea.problem.sightings,
                                      idea.directions_rad, loose, idea.chain.correction_rad)) {
    if (slip.share >= kLeastShare && slips.size() < kMost) slips.push_back(std::move(slip));
  }
  return slips;
}

/// Of attempts with one heading. Walls of two rooms that are held to be one confirm each other, but
/// bend odometry: a metre of wall counts as much as one of log likelihood.
double merit(const Attempt& attempt) { return attempt.score_m - attempt.strain; }

}  // namespace

void repair_slips(Readings readings, const DriveDirections& directions,
                  const SonarTrajectoryOptions& options, Idea& idea, SonarTrajectory& result) {
  constexpr int kMostTries = 12;
  std::vector<HeadingSlip> slips = possible_slips(idea);
  for (int tries = 0; !slips.empty() && tries < kMostTries;) {
    std::optional<Attempt> better;
    std::size_t better_slip = 0;
    for (std::size_t i = 0; i < slips.size() && tries < kMostTries; ++i, ++tries) {
      const double quarter = degrees(slips[i].more_rad.back());
      const auto at_m = std::lround(idea.problem.nodes[slips[i].first_node].path_m);
      std::string name = "turned by " + std::to_string(std::lround(quarter)) + " deg from " +
                         std::to_string(at_m) + " m on";
      Attempt attempt =
          solve(readings, directions, idea, std::move(name), slipped(idea, slips[i]), options);
      result.variants.push_back(attempt.variant);
      if (!is_better(attempt, idea.attempt)) continue;
      if (better && attempt.score_m <= better->score_m) continue;
      better = std::move(attempt);
      better_slip = i;
      result.chosen = result.variants.size() - 1;
    }
    if (!better) break;
    idea.attempt = std::move(*better);
    slips.erase(slips.begin() + static_cast<std::ptrdiff_t>(better_slip));
    ++result.slips_repaired;
  }
}

void refine(Readings readings, const DriveDirections& directions,
            const SonarTrajectoryOptions& options, Idea& idea, SonarTrajectory& result) {
  const auto offer = [&](Attempt attempt) {
    result.variants.push_back(attempt.variant);
    if (merit(attempt) <= merit(idea.attempt)) return false;
    result.chosen = result.variants.size() - 1;
    idea.attempt = std::move(attempt);
    return true;
  };
  const std::vector<double> heading_rad = idea.attempt.correction_rad;
  SonarBatchOptions wide;
  wide.start_scale_m = 1.5;
  SonarBatchOptions near;
  near.start_scale_m = 0.5;
  (void)offer(solve(readings, directions, idea, "from 1.5 m", heading_rad, options, wide));
  (void)offer(solve(readings, directions, idea, "from 0.5 m", heading_rad, options, near));
  constexpr int kMostTimes = 2;
  for (int times = 0; times < kMostTimes; ++times) {
    if (!offer(solve_again(readings, directions, idea, "walls extracted anew", options, near))) {
      break;
    }
  }
}

}  // namespace roomatlas
