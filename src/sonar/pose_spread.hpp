// SPDX-License-Identifier: GPL-3.0-or-later
// How far poses may be off: by what the equations of the batch leave open, and between attempts.
#pragma once

#include <span>
#include <vector>

#include "roomatlas/core/pose2.hpp"

namespace roomatlas {

class SonarEquations;

constexpr int kDraws = 48;  // tell a standard deviation to a tenth; one costs half of a solution,
                            // and a wild one a whole one

/// Moves of all nodes, drawn of the equations as last solved. Each draw is laid on the poses by
/// least squares, as a map is laid on the truth: what moves or turns all alike is not in it.
/// @returns of each draw, one a node: see `DrawnMoves`
[[nodiscard]] std::vector<std::vector<Pose2>> drawn_moves(const SonarEquations& equations,
                                                          const std::vector<Pose2>& map_from_node);

/// The same of the wild bootstrap: see `SonarEquations::draw_wild`.
[[nodiscard]] std::vector<std::vector<Pose2>> wild_moves(const SonarEquations& equations,
                                                         const std::vector<Pose2>& map_from_node);

/// From poses to as many others that were laid on them by least squares, each in the frame of its
/// own.
[[nodiscard]] std::vector<Pose2> moves_to(std::vector<Pose2> others, std::span<const Pose2> poses);

/// The motion that lays poses on as many others by their places.
[[nodiscard]] Pose2 fit(std::span<const Pose2> from, std::span<const Pose2> onto);

/// Root mean square of the distances between two trajectories, as many poses each, after one was
/// laid on the other by least squares; metres.
[[nodiscard]] double apart_m(std::span<const Pose2> a, std::span<const Pose2> b);

}  // namespace roomatlas
