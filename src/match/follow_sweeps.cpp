// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/match/follow_sweeps.hpp"

#include "roomatlas/mission/borrowed_mission.hpp"

#include <memory>
#include <optional>

namespace roomatlas {
namespace {

/// A mission's lasers, of which each one's odometry is kept, since matching puts its own there.
class Lasers : public BorrowedMission {
 public:
  Lasers(MissionSource& mission, const FollowSweepsOptions& options)
      : BorrowedMission(mission), options_(options) {}

  [[nodiscard]] std::optional<MissionEvent> next() override {
    while (left() > 0) {
      auto event = BorrowedMission::next();
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
  [[nodiscard]] int left() const { return options_.most_sweeps - sweeps_; }
  [[nodiscard]] const Pose2& odom_from_robot() const { return odom_from_robot_; }

 private:
  const FollowSweepsOptions& options_;
  std::optional<double> last_s_;
  Pose2 odom_from_robot_;
  int sweeps_ = 0;
};

}  // namespace

void follow_sweeps(MissionSource& mission, const FollowSweepsOptions& options,
                   const std::function<bool(const FollowedSweep&)>& take) {
  Lasers lasers(mission, options);
  MissionSource& borrowed = lasers;
  for (int tries = 0; tries < options.most_tries; ++tries) {
    const auto matched =
        scan_odometry(std::make_unique<BorrowedMission>(borrowed), options.matching);
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
