// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/mission/plausible.hpp"

#include "roomatlas/core/pose2.hpp"

#include <algorithm>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace roomatlas::io {

/// Finds poses that jump away and come back with the next one of their source: a wrong number in
/// one line. A jump that stays is odometry's own business and passes.
///
/// Messages come out in the order in which they went in, at once while nothing jumps. One that
/// jumps, and what is behind it, waits for the next pose of its source, or for `kMost` messages.
template <typename Message>
class SpikeFilter {
 public:
  static constexpr std::size_t kMost = 64;  ///< messages that wait: then the jump is believed

  struct Decided {
    Message message;
    double jump_m = 0.0;  ///< of a spike: how far it is from the pose before; else 0
  };

  SpikeFilter() = default;
  SpikeFilter(const SpikeFilter&) = delete;  // tracks point into the messages
  SpikeFilter& operator=(const SpikeFilter&) = delete;

  /// @param source whose poses follow each other
  /// @param pose of the robot, where the message has one
  void push(std::string_view source, const std::optional<StampedPose>& pose, Message message) {
    Held& held = held_.emplace_back(Held{std::move(message), 0.0, false});
    if (pose) judge(track_of(source), *pose, held);
    if (held_.size() >= kMost) settle_all(false);
  }
  /// Nothing follows: a jump that nothing confirms is a spike.
  void finish() { settle_all(true); }
  /// The next message about which all is known.
  [[nodiscard]] std::optional<Decided> take() {
    if (held_.empty() || held_.front().waits) return std::nullopt;
    Decided decided{std::move(held_.front().message), held_.front().jump_m};
    held_.pop_front();
    return decided;
  }

 private:
  struct Held {
    Message message;
    double jump_m = 0.0;
    bool waits = false;
  };
  struct Track {
    std::optional<StampedPose> last;  ///< that was believed
    StampedPose jumped;
    Held* waiting = nullptr;  ///< the message with that pose
  };

  Track& track_of(std::string_view source) {
    const auto found = tracks_.find(source);
    return found != tracks_.end() ? found->second : tracks_[std::string(source)];
  }

  void judge(Track& track, const StampedPose& pose, Held& held) {
    if (track.waiting != nullptr) {
      settle(track, is_jump(track.jumped, pose) && !is_jump(*track.last, pose));
    }
    if (!track.last || !is_jump(*track.last, pose)) {
      track.last = pose;
      return;
    }
    held.jump_m = (pose.pose.position() - track.last->pose.position()).norm();
    held.waits = true;
    track.jumped = pose;
    track.waiting = &held;
  }

  static void settle(Track& track, bool is_spike) {
    Held& held = *std::exchange(track.waiting, nullptr);
    held.waits = false;
    if (is_spike) return;
    held.jump_m = 0.0;
    track.last = track.jumped;
  }

  void settle_all(bool as_spikes) {
    for (auto& [source, track] : tracks_) {
      if (track.waiting != nullptr) settle(track, as_spikes);
    }
  }

  std::deque<Held> held_;  ///< in file order; its elements stay where they are
  std::map<std::string, Track, std::less<>> tracks_;
};

}  // namespace roomatlas::io
