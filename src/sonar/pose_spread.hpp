// SPDX-License-Identifier: GPL-3.0-or-later
// How far poses may be off: by what the equations of the batch leave open, and between attempts.
#pragma once

#include <span>
#include <vector>

#include "roomatlas/core/pose2.hpp"
#include "roomatlas/sonar/sonar_trajectory.hpp"

namespace roomatlas {

class SonarEquations;

/// Moves of all nodes, drawn of the equations as last solved. Each draw is laid on the poses by
/// least squares, as a map is laid on the truth: what moves or turns all alike is not in it.
/// @returns of each draw, one a node: see `DrawnMoves`
[[nodiscard]] std::vector<std::vector<Pose2>> drawn_moves(const SonarEquations& equations,
                                                          const std::vector<Pose2>& map_from_node);

/// Of each node: root mean squares of what was drawn; nothing where nothing was.
[[nodiscard]] std::vector<PoseSpread> spread_of(const std::vector<std::vector<Pose2>>& moves);

/// The motion that lays poses on as many others by their places.
[[nodiscard]] Pose2 fit(std::span<const Pose2> from, std::span<const Pose2> onto);

/// Root mean square of the distances between two trajectories, as many poses each, after one was
/// laid on the other by least squares; metres.
[[nodiscard]] double apart_m(std::span<const Pose2> a, std::span<const Pose2> b);

}  // namespace roomatlas
