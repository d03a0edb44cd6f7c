// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/mission/one_sensor_kind.hpp"

#include <deque>
#include <string>
#include <utility>

namespace roomatlas {
namespace {

class OneSensorKindSource : public MissionSource {
 public:
  explicit OneSensorKindSource(std::unique_ptr<MissionSource> mission)
      : mission_(std::move(mission)) {}

  [[nodiscard]] std::optional<MissionEvent> next() override {
    if (!kind_) decide();
    while (auto event = next_of_any()) {
      const auto* reading = std::get_if<RangeReading>(&*event);
      if (reading == nullptr || reading->sensor->kind == *kind_) return event;
      ++left_out_;
    }
    return std::nullopt;
  }

  [[nodiscard]] const MissionInfo& info() const override {
    info_ = mission_->info();
    if (left_out_ == 0) return info_;
    info_.readings -= left_out_;
    const bool is_laser = *kind_ == SensorKind::laser;
    info_.issues.insert(
        info_.issues.begin(),
        {Severity::warning, info_.file, 0, "sensors",
         std::to_string(left_out_) +
             (is_laser ? " sonar readings are left out: the log has a laser, which alone is mapped"
                       : " laser readings are left out: the log begins with sonars, which alone "
                         "are mapped; cut it where the laser begins")});
    return info_;
  }

  [[nodiscard]] double progress() const override { return mission_->progress(); }

 private:
  /// Looks ahead for a laser.
  void decide() {
    constexpr int kLookAhead = 200;  // range readings
    kind_ = SensorKind::sonar;
    for (int readings = 0; readings < kLookAhead;) {
      held_.push_back(mission_->next());
      if (!held_.back()) return;
      const auto* reading = std::get_if<RangeReading>(&*held_.back());
      if (reading == nullptr) continue;
      ++readings;
      if (reading->sensor->kind == SensorKind::laser) {
        kind_ = SensorKind::laser;
        return;
      }
    }
  }

  std::optional<MissionEvent> next_of_any() {
    if (held_.empty()) return mission_->next();
    std::optional<MissionEvent> event;
    event.swap(held_.front());
    held_.pop_front();
    return event;
  }

  std::unique_ptr<MissionSource> mission_;
  std::optional<SensorKind> kind_;
  std::deque<std::optional<MissionEvent>> held_;  ///< read ahead
  std::int64_t left_out_ = 0;
  mutable MissionInfo info_;
};

}  // namespace

std::unique_ptr<MissionSource> one_sensor_kind(std::unique_ptr<MissionSource> mission) {
  return std::make_unique<OneSensorKindSource>(std::move(mission));
}

}  // namespace roomatlas
