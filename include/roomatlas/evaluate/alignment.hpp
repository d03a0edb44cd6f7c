// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/pose2.hpp"
#include "roomatlas/evaluate/pose_lookup.hpp"

#include <vector>

namespace roomatlas {

/// Poses of a trajectory and the true ones at the same times; all lists are as long.
struct MatchedPoses {
  std::vector<double> timestamps_s;
  std::vector<Pose2> estimate_from_robot;
  std::vector<Pose2> truth_from_robot;
  MatchUse use;  ///< of the side that was looked up

  [[nodiscard]] std::size_t size() const { return timestamps_s.size(); }
};

/// Brings a trajectory and true poses together. As in evo the times of the shorter one are looked
/// up in the longer one, in file order; times without an answer are left out.
/// @param carry odometry that fills gaps of the estimate; may be null. With it the estimate is
///   looked up at the truth's times, whichever is longer
[[nodiscard]] MatchedPoses match_poses(const Trajectory& estimate, const Trajectory& truth,
                                       const MatchOptions& options,
                                       const Trajectory* carry = nullptr);

/// How an estimate is moved onto the truth before it is compared, always rigidly.
enum class Alignment {
  none,
  origin,   ///< the first matched pose falls onto the true one
  umeyama,  ///< least squares over positions (Umeyama 1991, in the plane, without scale)
};
[[nodiscard]] const char* to_string(Alignment alignment);

/// The motion that takes the estimate's frame into the truth's; the identity for no poses. Where
/// all positions are one point, least squares leaves the turn open and it is 0.
/// @param poses_used how many poses from the start decide; negative: all
[[nodiscard]] Pose2 truth_from_estimate(const MatchedPoses& matched, Alignment alignment,
                                        int poses_used = -1);

}  // namespace roomatlas
