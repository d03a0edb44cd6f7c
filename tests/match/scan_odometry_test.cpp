// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/match/scan_odometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace roomatlas {
namespace {

/// A room of 6 m x 4 m with a column, which tells all directions apart.
double range_in_room(const Pose2& beam) {
  const Point2 ray = direction(beam.theta_rad);
  double range_m = std::numeric_limits<double>::infinity();
  const auto meet = [&](const Point2& a, const Point2& b) {
    const Point2 along = b - a;
    const double across = ray.x() * along.y() - ray.y() * along.x();
    if (std::abs(across) < 1e-12) return;
    const Point2 off = a - beam.position();
    const double at_m = (off.x() * along.y() - off.y() * along.x()) / across;
    const double share = (off.x() * ray.y() - off.y() * ray.x()) / across;
    if (at_m > 0.0 && share >= 0.0 && share <= 1.0) range_m = std::min(range_m, at_m);
  };
  const auto box = [&](const Point2& low, const Point2& high) {
    meet(low, {high.x(), low.y()});
    meet({high.x(), low.y()}, high);
    meet(high, {low.x(), high.y()});
    meet({low.x(), high.y()}, low);
  };
  box({-3.0, -2.0}, {3.0, 2.0});
  box({1.8, 0.8}, {2.2, 1.2});
  return range_m;
}

Pose2 truth_at(double time_s) {
  return {1.2 * std::sin(0.4 * time_s), 0.8 * std::sin(0.8 * time_s), wrap_angle(0.5 * time_s)};
}

/// One who stands, and turns at once, farther than matching looks for.
Pose2 jerks_at(double time_s) { return {0.3, -0.2, wrap_angle(1.2 * std::floor(0.7 * time_s))}; }

class Walk : public MissionSource {
 public:
  /// @param sweep_s from the first beam to the last
  explicit Walk(bool jumps, double sweep_s = 0.0, double told_s = 0.0,
                Pose2 (*pose_at)(double) = truth_at)
      : jumps_(jumps), sweep_s_(sweep_s), told_s_(told_s), pose_at_(pose_at) {
    auto sensor = std::make_shared<RangeSensor>();
    sensor->max_range_m = 20.0;
    for (int i = 0; i < 360; ++i) {
      sensor->robot_from_beam.push_back({0.0, 0.0, wrap_angle(radians(i - 180.0))});
    }
    sensor_ = sensor;
    info_.odometry = "none";
  }
  [[nodiscard]] std::optional<MissionEvent> next() override {
    const double time_s = 0.1 * step_;
    if (step_++ >= 300) return std::nullopt;
    RangeReading reading{time_s, {}, sensor_, {}, told_s_};
    for (const Pose2& beam : sensor_->robot_from_beam) {
      const double share = static_cast<double>(reading.ranges_m.size()) / 359.0;
      const double passed_s = sweep_s_ < 0.0 ? sweep_s_ * (share - 1.0) : sweep_s_ * share;
      const double range_m = range_in_room(pose_at_(time_s + passed_s) * beam);
      const double torn_m = 1.0 + 3.0 * std::abs(std::sin(1e4 * beam.theta_rad * (step_ + 1)));
      reading.ranges_m.push_back(static_cast<float>(jumps_ && step_ > 100 ? torn_m : range_m));
    }
    return reading;
  }
  [[nodiscard]] const MissionInfo& info() const override { return info_; }
  [[nodiscard]] double progress() const override { return step_ / 300.0; }

 private:
  bool jumps_;
  double sweep_s_;
  double told_s_;
  Pose2 (*pose_at_)(double);
  int step_ = 0;
  std::shared_ptr<const RangeSensor> sensor_;
  MissionInfo info_;
};

TEST(ScanOdometry, FollowsAWalkThroughARoom) {
  const auto mission = scan_odometry(std::make_unique<Walk>(false));
  const Pose2 start = truth_at(0.0);
  int readings = 0;
  while (const auto event = mission->next()) {
    const auto& reading = std::get<RangeReading>(*event);
    const Pose2 expected = inverse(start) * truth_at(reading.timestamp_s);
    const Pose2 off = inverse(expected) * reading.odom_from_robot;
    EXPECT_LT(off.position().norm(), 0.06) << reading.timestamp_s;
    EXPECT_LT(std::abs(off.theta_rad), radians(1.5)) << reading.timestamp_s;
    ++readings;
  }
  EXPECT_EQ(readings, 300);
  EXPECT_EQ(mission->info().odometry, "scan matching");
  EXPECT_GT(mission->info().path_length_m, 5.0);
  ASSERT_FALSE(mission->info().issues.empty());
  EXPECT_EQ(mission->info().issues.front().severity, Severity::warning);
}

/// How far the ends of all beams are from the walls of the room, seen from where the robot was.
double mean_miss_m(double sweep_s, double told_s) {
  const auto mission = scan_odometry(std::make_unique<Walk>(false, sweep_s, told_s));
  double sum_m = 0.0;
  double ends = 0.0;
  while (const auto event = mission->next()) {
    const auto& reading = std::get<RangeReading>(*event);
    EXPECT_EQ(reading.sweep_s, 0.0);
    const Pose2 room_from_robot = truth_at(reading.timestamp_s);
    for (std::size_t i = 0; i < reading.ranges_m.size(); ++i) {
      if (!std::isfinite(reading.ranges_m[i])) continue;
      const Point2 end =
          room_from_robot * (reading.sensor->robot_from_beam[i] * Point2(reading.ranges_m[i], 0.0));
      if ((end - Point2(2.0, 1.0)).norm() < 0.6) continue;  // the column
      sum_m += std::min(std::abs(3.0 - std::abs(end.x())), std::abs(2.0 - std::abs(end.y())));
      ends += 1.0;
    }
  }
  return sum_m / ends;
}

TEST(ScanOdometry, PutsEachBeamOfASweepToItsOwnPose) {
  for (const double sweep_s : {0.1, -0.1}) {
    EXPECT_LT(mean_miss_m(sweep_s, sweep_s), 0.3 * mean_miss_m(sweep_s, 0.0));
  }
}

/// The jerks as a sweep a tenth of a second, with a gyro's headings 3 % too large.
class Jerks : public Walk {
 public:
  Jerks() : Walk(false, 0.0, 0.0, jerks_at) {}
  [[nodiscard]] std::optional<MissionEvent> next() override {
    auto event = Walk::next();
    if (event) {
      auto& reading = std::get<RangeReading>(*event);
      reading.odom_from_robot.theta_rad =
          wrap_angle(1.03 * 1.2 * std::floor(0.7 * reading.timestamp_s));
    }
    return event;
  }
};

double most_off_rad(bool turns_are_told) {
  ScanOdometryOptions options;
  options.turns_are_told = turns_are_told;
  const auto mission = scan_odometry(std::make_unique<Jerks>(), options);
  double most_rad = 0.0;
  while (const auto event = mission->next()) {
    const auto& reading = std::get<RangeReading>(*event);
    const double turned = wrap_angle(jerks_at(reading.timestamp_s).theta_rad);
    most_rad = std::max(most_rad, std::abs(wrap_angle(reading.odom_from_robot.theta_rad - turned)));
  }
  return most_rad;
}

TEST(ScanOdometry, FollowsTurnsThatAGyroTold) {
  EXPECT_LT(most_off_rad(true), radians(1.5));
  EXPECT_THROW((void)most_off_rad(false), NotEnoughError);  // else this shows nothing
}

TEST(ScanOdometry, RefusesWhatNoSweepFits) {
  const auto mission = scan_odometry(std::make_unique<Walk>(true));
  EXPECT_THROW(while (mission->next()){}, NotEnoughError);
}

}  // namespace
}  // namespace roomatlas
