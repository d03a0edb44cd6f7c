// SPDX-License-Identifier: GPL-3.0-or-later
// What is tried of a mission with sonars, and what of it is kept. Each function adds what it tried
// to the result's variants, in the order in which it was offered.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sonar_attempt.hpp"

namespace roomatlas {

/// What stays of several ideas, and what does not.
struct Choice {
  std::optional<Idea> best;
  std::vector<Attempt> others;

  /// The first stays unless another takes over.
  void offer(Idea idea, SonarTrajectory& result);
};

/// The best by its heading, and the map that needs none to begin with.
struct Start {
  Choice choice;
  Idea from_beginning;
};

/// Headings by the building's walls, where these follow directions, and odometry's own.
[[nodiscard]] Start choose_heading(const SonarMission& mission, const Calibration& likely,
                                   SonarTrajectory& result);

/// The building's directions as a map tells them on which no wall follows any. The chain of the
/// heading takes a wing that it does not know for the nearest direction that it knows, and bends
/// the way there; where rooms radiate it has nothing to hold on to. Such a map has more freedom:
/// one that fits worse than the best has gone astray, and tells nothing.
void consider_free_map(const SonarMission& mission, Idea from_beginning, Choice& choice,
                       SonarTrajectory& result);

/// Habits of odometry near the likely ones.
void consider_other_habits(const SonarMission& mission, const Calibration& likely, Choice& choice,
                           SonarTrajectory& result);

/// The building's directions as the map tells them that walls and odometry make of the best without
/// any: a wing that the best has in the directions of the rest turns away from them there. It must
/// fit better, and take a tenth of what strains odometry.
/// @param choice whose best has directions
/// @return the map without directions, of the one that stays
[[nodiscard]] Idea reconsider_directions(const SonarMission& mission, Choice& choice,
                                         SonarTrajectory& result);

/// Keeps another attempt, as it was tried: what is left of its idea is no base to refine it on.
/// @param other its place in the choice's others
void take(const SonarMission& mission, std::size_t other, Choice& choice, SonarTrajectory& result);

}  // namespace roomatlas
