// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/match/follow_sweeps.hpp"

#include <memory>
#include <optional>

namespace roomatlas {
namespace {

/// A mission's lasers, of which each one's odometry is kept, since matching puts its own there.
class Lasers : public MissionSource {
 public:
  Lasers(MissionSource& mission, const FollowSweepsOptions& options)
      : mission_(mission), options_(options) {}

  [[nodiscard]] std::optional<MissionEvent> next() override {
    while (left() > 0) {
      auto event = mission_.next();
      if (!event) return std::nullopt;
      const auto* reading = std::get_if<RangeReading>(&*event);
      if (reading == nullptr || reading->sensor->kind != SensorKind::laser) continue;
      const double passed_s = reading->timestamp_s - last_s_.value_or(-1e300);
      if (passed_s >= 0.0 && passed_s < options_.apart_s) continue;
      last_s_ = reading->timestamp_s;
      odom_from_robot_ = reading->odom_from_robot;
      ++sweeps_;
      return event;
    }
    return std::nullopt;
  }
  [[nodiscard]] const MissionInfo& info() const override { return mission_.info(); }
  [[nodiscard]] double progress() const override { return mission_.progress(); }

  [[nodiscard]] int left() const { return options_.most_sweeps - sweeps_; }
  [[nodiscard]] const Pose2& odom_from_robot() const { return odom_from_robot_; }

 private:
  MissionSource& mission_;
  const FollowSweepsOptions& options_;
  std::optional<double> last_s_;
  Pose2 odom_from_robot_;
  int sweeps_ = 0;
};

/// Gives its turns away to who owns it.
class Borrowed : public MissionSource {
 public:
  explicit Borrowed(MissionSource& mission) : mission_(mission) {}
  [[nodiscard]] std::optional<MissionEvent> next() override { return mission_.next(); }
  [[nodiscard]] const MissionInfo& info() const override { return mission_.info(); }
  [[nodiscard]] double progress() const override { return mission_.progress(); }

 private:
  MissionSource& mission_;
};

}  // namespace

void follow_sweeps(MissionSource& mission, const FollowSweepsOptions& options,
                   const std::function<bool(const FollowedSweep&)>& take) {
  Lasers lasers(mission, options);
  for (int tries = 0; tries < options.most_tries; ++tries) {
    const auto matched = scan_odometry(std::make_unique<Borrowed>(lasers), options.matching);
    bool goes_on = false;
    try {
      while (const auto event = matched->next()) {
        const auto& reading = std::get<RangeReading>(*event);
        const FollowedSweep sweep{reading.timestamp_s, lasers.odom_from_robot(),
                                  reading.odom_from_robot, goes_on};
        if (!take(sweep)) return;
        goes_on = true;
      }
      return;
    } catch (const NotEnoughError&) {  // lost: what comes now is begun anew
    }
  }
}

}  // namespace roomatlas
