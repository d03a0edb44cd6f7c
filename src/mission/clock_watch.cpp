// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/mission/clock_watch.hpp"

#include <cstdio>
#include <string>
#include <utility>

#include "roomatlas/core/counted.hpp"

namespace roomatlas {
namespace {

constexpr double kStepBack_s = 1.0;  // less is the order in which sensors were written
constexpr double kFarApart_s = 60.0;

std::string seconds(double value_s) {
  char text[64];
  std::snprintf(text, sizeof text, "%.1f s", value_s);
  return text;
}

class WatchedClock : public MissionSource {
 public:
  explicit WatchedClock(std::unique_ptr<MissionSource> mission) : mission_(std::move(mission)) {}

  [[nodiscard]] std::optional<MissionEvent> next() override {
    auto event = mission_->next();
    if (event) {
      if (const auto* reading = std::get_if<RangeReading>(&*event)) look_at(reading->timestamp_s);
    }
    return event;
  }

  [[nodiscard]] const MissionInfo& info() const override {
    info_ = mission_->info();
    if (info_.has_times) tell();
    return info_;
  }

  [[nodiscard]] double progress() const override { return mission_->progress(); }

 private:
  void look_at(double time_s) {
    if (readings_++ == 0) first_s_ = time_s;
    if (readings_ > 1 && time_s < last_s_ - kStepBack_s && steps_back_++ == 0) {
      before_s_ = last_s_;
      after_s_ = time_s;
      at_reading_ = readings_;
    }
    last_s_ = time_s;
  }

  void tell() const {
    if (steps_back_ > 0) {
      warn("goes back " + counted(steps_back_, "time") + ", first from " + seconds(before_s_) +
           " to " + seconds(after_s_) + " at reading " + std::to_string(at_reading_) +
           ": readings are taken in their order, and true poses found by their times may be "
           "another's");
      return;
    }
    if (readings_ < 2) return;
    const double apart_s = (last_s_ - first_s_) / static_cast<double>(readings_ - 1);
    if (apart_s < kFarApart_s) return;
    warn("readings are " + seconds(apart_s) +
         " apart in the mean: times are expected in seconds; are these in milliseconds?");
  }

  void warn(const std::string& text) const {
    info_.issues.insert(info_.issues.begin(), {Severity::warning, info_.file, 0, "time", text});
  }

  std::unique_ptr<MissionSource> mission_;
  std::int64_t readings_ = 0;
  std::int64_t steps_back_ = 0;
  std::int64_t at_reading_ = 0;
  double first_s_ = 0.0;
  double last_s_ = 0.0;
  double before_s_ = 0.0;  ///< the first step back: from here ...
  double after_s_ = 0.0;   ///< ... to here
  mutable MissionInfo info_;
};

}  // namespace

std::unique_ptr<MissionSource> with_clock_watched(std::unique_ptr<MissionSource> mission) {
  return std::make_unique<WatchedClock>(std::move(mission));
}

}  // namespace roomatlas
