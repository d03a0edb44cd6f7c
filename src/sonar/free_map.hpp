// SPDX-License-Identifier: GPL-3.0-or-later
// Maps on which no wall follows any direction: odometry and walls seen again hold them together.
// They tell which directions a building has, and are the answer where it has none.
#pragma once

#include <vector>

#include "map_directions.hpp"
#include "sonar_attempt.hpp"

namespace roomatlas {

/// Solved from the mission's beginning on, a stretch more each time: each begins where the one
/// before ended, with the habits of odometry that it taught, so that walls are seen again before
/// the heading has drifted far. It needs no direction of any wall, neither for the heading nor for
/// the habits; in a building whose rooms radiate those tell nothing of either.
/// @param calibration where to start; its lag and scale stay
[[nodiscard]] Idea grown(const SonarMission& mission, const Calibration& calibration);

/// Solved at once, from the heading of an idea whose walls follow directions.
[[nodiscard]] Idea loosened(const SonarMission& mission, const Idea& idea);

/// Solved once more without directions, from where an idea with directions ended: odometry and
/// walls seen again alone turn it as far as they will.
[[nodiscard]] Idea undirected(const SonarMission& mission, const Idea& idea);

/// The walls of an idea, on its map.
[[nodiscard]] std::vector<MapWall> walls_on(const Idea& idea);

/// Solved from a free map with walls in the directions that they follow on it; where fewer than
/// half of them follow any, rooms radiate, and more directions are tried, too.
/// @param walls_rad `map_directions` of the map, not empty
[[nodiscard]] Idea directed(const SonarMission& mission, const Idea& free,
                            const std::vector<double>& walls_rad);

}  // namespace roomatlas
