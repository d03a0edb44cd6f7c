// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <optional>
#include <utility>

#include "roomatlas/core/packed.hpp"
#include "roomatlas/odometry/dead_reckoner.hpp"

namespace roomatlas {

/// Readings with odometry that is late put right: each gets the step that odometry reported as much
/// later (or earlier). A stream: readings wait for those whose odometry they need; memory does not
/// grow with the mission.
class LateOdometry {
 public:
  void add(DeadReckoned reading) { readings_.push_back(std::move(reading)); }
  /// The mission has ended: odometry stands still after its last pose.
  void finish() { has_ended_ = true; }

  /// The next reading in order; nothing while the odometry for it has not come.
  /// @param lag_s see `OdometryHabits::lag_s`, of at most a second either way; without one the
  ///   poses are those that were added, up to a rigid motion since the lag was another
  [[nodiscard]] std::optional<DeadReckoned> next(double lag_s);

  /// What later readings hang on besides those that were added.
  struct State {
    Pose2 last_reckoned_from_robot;  ///< of the last reading that was given
    bool is_shifted = false;         ///< some step was another than the one that was added
  };
  /// Of a stream that has given a reading.
  [[nodiscard]] State state() const { return {last_.value().reckoned_from_robot, is_shifted_}; }
  /// Passes over the next reading, as one that this stream had given before it was stopped.
  /// @returns the reading; nothing while it has not come
  [[nodiscard]] std::optional<RangeReading> skip();
  /// Goes on behind the readings that were passed over as the stream did that was in this state.
  void resume(const State& state);

 private:
  [[nodiscard]] Pose2 reckoned_at(double timestamp_s) const;
  void forget();

  std::deque<DeadReckoned> readings_;  ///< some that were given, then those that wait
  std::size_t given_ = 0;              ///< of `readings_`
  bool has_ended_ = false;
  std::optional<DeadReckoned> last_;  ///< as given
  bool is_shifted_ = false;           ///< see `State`
};

template <MaybeConst<LateOdometry::State> Value, typename Visit>
void fields_of(Value& state, Visit& visit) {
  visit(state.last_reckoned_from_robot, state.is_shifted);
}

}  // namespace roomatlas
