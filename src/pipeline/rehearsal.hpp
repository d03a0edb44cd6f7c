// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "roomatlas/match/room_localizer.hpp"
#include "roomatlas/odometry/late_odometry.hpp"

namespace roomatlas {

/// Follows a laser mission's beginning once before it is recorded. What odometry reports wrongly is
/// known then when the first room is mapped, which otherwise comes out bent until it is: it is
/// learnt in some ten metres. Costs the time of those once more; memory is bounded.
class Rehearsal {
 public:
  explicit Rehearsal(const LocalizeOptions& options) : localizer_(options) {}

  /// Takes the next reading of the mission, until it is over.
  void add(const DeadReckoned& reading);
  /// Whether enough was driven, or nothing is to be learnt: sonars are not matched.
  [[nodiscard]] bool is_over() const;
  /// What is known of odometry, for a localizer that begins where the mission does; nothing where
  /// that is little.
  [[nodiscard]] LearntOdometry learnt() const;

 private:
  void follow(const DeadReckoned& next);

  LateOdometry waiting_;
  RoomLocalizer localizer_;
  std::optional<Pose2> last_reckoned_from_robot_;
  Pose2 room_from_robot_;
  double driven_m_ = 0.0;
  std::int64_t readings_ = 0;
  bool has_laser_ = true;
};

}  // namespace roomatlas
