// SPDX-License-Identifier: GPL-3.0-or-later
// How far the attempt that is kept can be relied on: what the others say of it, and its own walls.
#pragma once

#include <span>
#include <vector>

#include "sonar_attempt.hpp"

namespace roomatlas {

/// Of the readings. Without directions to follow walls cannot tell the heading: it counts as sure.
[[nodiscard]] double share_with_sure_heading(const Idea& idea);

/// The best score among attempts that wind otherwise, over that of the one kept.
[[nodiscard]] double rival_score(const Attempt& kept, const std::vector<Attempt>& others);

/// How far attempts that do nearly as well end from the one kept: root mean square over all, each
/// weighed by how near its score is, the one kept with 1.
[[nodiscard]] double attempts_apart(const Attempt& kept, const std::vector<Attempt>& others);

/// How far attempts with walls in directions that fit nearly as well are turned against the one
/// kept: root mean square over all, each weighed by how near its merit is, the one kept with 1.
[[nodiscard]] double headings_apart(const Attempt& kept, const std::vector<Attempt>& others);

/// Of one other solution, each reading a node.
[[nodiscard]] DrawnMoves moves_of_readings(std::vector<Pose2> other,
                                           const std::vector<Pose2>& kept);

/// How the mission comes out by other means.
/// @param grown from the beginning, see `free_map`
[[nodiscard]] CrossCheck cross_checked(const Attempt& kept, const Attempt& grown,
                                       const std::vector<Attempt>& others);

/// Whether the heading is sure, enough wall was seen by several visits, they agree about it, and no
/// attempt that winds otherwise does nearly as well: what it turns must cost it walls.
[[nodiscard]] bool is_verified(const Idea& idea, const std::vector<Attempt>& others,
                               const SonarTrajectoryOptions& options);

/// Of the attempts that wind otherwise the best, where chance may have preferred the one kept.
[[nodiscard]] const Attempt* second_answer(std::span<const RangeReading> readings,
                                           const Attempt& kept, const std::vector<Attempt>& others);

}  // namespace roomatlas
