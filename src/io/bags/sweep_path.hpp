// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/robot_poses.hpp"

#include "roomatlas/core/pose2.hpp"

#include <cstdint>
#include <vector>

namespace roomatlas::io {

/// Where the robot was in the course of a sweep, from where it was at the reading's time.
class SweepPath {
 public:
  SweepPath() = default;  ///< nobody knows: it stands
  SweepPath(const RobotPoses& poses, std::int64_t reading_ns, std::int64_t begin_ns,
            std::int64_t end_ns);

  /// More than what can be neglected.
  [[nodiscard]] bool moves() const;
  /// @param share of the sweep that has passed, [0, 1]
  [[nodiscard]] Pose2 at(double share) const;

 private:
  std::vector<Pose2> knots_;  ///< between them straight
  double still_share_ = 1.0;
};

}  // namespace roomatlas::io
