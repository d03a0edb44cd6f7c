// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/mission/as_sonar.hpp"

#include <algorithm>
#include <utility>

#include "sonar_cones.hpp"

namespace roomatlas {
namespace {

class AsSonarSource : public MissionSource {
 public:
  AsSonarSource(std::unique_ptr<MissionSource> mission, const AsSonarOptions& options,
                double max_range_m)
      : mission_(std::move(mission)), options_(options), max_range_m_(max_range_m) {}

  [[nodiscard]] std::optional<MissionEvent> next() override {
    auto event = mission_->next();
    if (event) {
      if (auto* reading = std::get_if<RangeReading>(&*event)) thin(*reading);
    }
    return event;
  }

  /// As of the log, with the rings in the place of the lasers.
  [[nodiscard]] const MissionInfo& info() const override {
    info_ = mission_->info();
    for (auto& sensor : info_.sensors) {
      const auto known = cones_of(sensor);
      if (known != known_.end()) sensor = known->ring;
    }
    return info_;
  }

  [[nodiscard]] double progress() const override { return mission_->progress(); }

 private:
  using Known = std::vector<SonarCones>;

  [[nodiscard]] Known::const_iterator cones_of(
      const std::shared_ptr<const RangeSensor>& sensor) const {
    return std::find_if(known_.begin(), known_.end(),
                        [&](const SonarCones& cones) { return cones.laser == sensor; });
  }

  void thin(RangeReading& reading) {
    const std::uint64_t number = readings_++;
    if (reading.sensor->kind != SensorKind::laser) return;
    auto known = cones_of(reading.sensor);
    if (known == known_.end()) {
      if (known_.size() >= kMostKnown) known_.erase(known_.begin());
      known_.push_back(sonar_cones(reading.sensor, max_range_m_));
      known = known_.end() - 1;
    }
    reading.ranges_m = heard(*known, reading.ranges_m, options_, number);
    reading.sensor = known->ring;
  }

  static constexpr std::size_t kMostKnown = 64;  // a log whose sensor keeps changing is not kept
  std::unique_ptr<MissionSource> mission_;
  AsSonarOptions options_;
  double max_range_m_;
  Known known_;
  std::uint64_t readings_ = 0;
  mutable MissionInfo info_;
};

}  // namespace

std::unique_ptr<MissionSource> as_sonar(std::unique_ptr<MissionSource> mission,
                                        const AsSonarOptions& options, double max_range_m) {
  return std::make_unique<AsSonarSource>(std::move(mission), options, max_range_m);
}

}  // namespace roomatlas
