// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/mission/odometry_jumps.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "roomatlas/core/counted.hpp"
#include "roomatlas/mission/plausible.hpp"

namespace roomatlas {
namespace {

class WithoutJumps : public MissionSource {
 public:
  explicit WithoutJumps(std::unique_ptr<MissionSource> mission) : mission_(std::move(mission)) {}

  [[nodiscard]] std::optional<MissionEvent> next() override {
    auto event = mission_->next();
    if (event) {
      if (auto* reading = std::get_if<RangeReading>(&*event)) join(*reading);
    }
    return event;
  }

  [[nodiscard]] const MissionInfo& info() const override {
    info_ = mission_->info();
    if (jumps_ == 0) return info_;
    info_.path_length_m -= jumped_m_;
    info_.issues.insert(
        info_.issues.begin(),
        {Severity::warning, info_.file, 0, "odometry",
         "jumps " + counted(jumps_, "time") + ", the first time by " +
             std::to_string(std::llround(first_m_)) + " m at " + std::to_string(first_s_) +
             " s: no robot drives so fast; the jumps are taken for standing"});
    return info_;
  }

  [[nodiscard]] double progress() const override { return mission_->progress(); }

 private:
  /// Puts a reading where odometry would be without the jumps so far.
  void join(RangeReading& reading) {
    const StampedPose reported{reading.timestamp_s, reading.odom_from_robot};
    if (last_ && is_jump(*last_, reported)) {
      const Point2 step = reported.pose.position() - last_->pose.position();
      if (jumps_++ == 0) {
        first_m_ = step.norm();
        first_s_ = reading.timestamp_s;
      }
      jumped_m_ += step.norm();
      moved_ -= step;
    }
    last_ = reported;
    if (jumps_ == 0) return;
    reading.odom_from_robot.x_m += moved_.x();
    reading.odom_from_robot.y_m += moved_.y();
  }

  std::unique_ptr<MissionSource> mission_;
  std::optional<StampedPose> last_;  ///< as reported
  Point2 moved_ = Point2::Zero();    ///< what takes the jumps out
  int jumps_ = 0;
  double first_m_ = 0.0;
  double first_s_ = 0.0;
  double jumped_m_ = 0.0;
  mutable MissionInfo info_;
};

}  // namespace

std::unique_ptr<MissionSource> without_odometry_jumps(std::unique_ptr<MissionSource> mission) {
  return std::make_unique<WithoutJumps>(std::move(mission));
}

}  // namespace roomatlas
