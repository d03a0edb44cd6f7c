// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "roomatlas/mission/mission.hpp"

namespace roomatlas::test {

/// A mission that is a list of events.
class MemoryMission : public MissionSource {
 public:
  explicit MemoryMission(std::vector<MissionEvent> events, std::string odometry = "ODOM lines")
      : events_(std::move(events)) {
    info_.file = "memory.clf";
    info_.odometry = std::move(odometry);
  }
  std::optional<MissionEvent> next() override {
    if (next_ == events_.size()) return std::nullopt;
    const bool is_reading = std::holds_alternative<RangeReading>(events_[next_]);
    (is_reading ? info_.readings : info_.true_poses) += 1;
    return events_[next_++];
  }
  [[nodiscard]] const MissionInfo& info() const override { return info_; }
  [[nodiscard]] double progress() const override {
    return events_.empty() ? 1.0 : static_cast<double>(next_) / static_cast<double>(events_.size());
  }

 private:
  std::vector<MissionEvent> events_;
  std::size_t next_ = 0;
  MissionInfo info_;
};

}  // namespace roomatlas::test
