// SPDX-License-Identifier: GPL-3.0-or-later
#include "logs/beam_fan.hpp"

#include "bags/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace roomatlas::io {
namespace {

constexpr double kSameM = 1e-6;
constexpr double kSameRad = 1e-5;  // a millimetre at 100 m

/// From the first beam to the last, the way along which they lie.
double turn_over(const std::vector<Pose2>& beams) {
  double turn_rad = 0.0;
  for (std::size_t i = 1; i < beams.size(); ++i) {
    turn_rad += wrap_angle(beams[i].theta_rad - beams[i - 1].theta_rad);
  }
  return turn_rad;
}

BeamFan even_fan(const std::vector<Pose2>& beams) {
  const double gaps = std::max(1.0, static_cast<double>(beams.size()) - 1.0);
  return {beams.front().position(), beams.front().theta_rad, turn_over(beams) / gaps};
}

Echo echo_in(float range_m, const RangeSensor& sensor) {
  if (!std::isfinite(range_m) || range_m <= 0.0F) return Echo::unknown;
  return static_cast<double>(range_m) >= sensor.max_range_m ? Echo::nothing : Echo::surface;
}

}  // namespace

std::optional<BeamFan> fan_of(const RangeSensor& laser) {
  const std::vector<Pose2>& beams = laser.robot_from_beam;
  if (beams.empty()) return std::nullopt;
  const BeamFan fan = even_fan(beams);
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const double even_rad = fan.first_rad + static_cast<double>(i) * fan.step_rad;
    if ((beams[i].position() - fan.origin).norm() > kSameM) return std::nullopt;
    if (std::abs(wrap_angle(beams[i].theta_rad - even_rad)) > kSameRad) return std::nullopt;
  }
  return fan;
}

RangeReading as_fan(const RangeReading& reading) {
  const RangeSensor& sensor = *reading.sensor;
  if (sensor.robot_from_beam.size() < 2 || fan_of(sensor)) return reading;
  const BeamFan fan = even_fan(sensor.robot_from_beam);
  const std::size_t beams = sensor.robot_from_beam.size();
  auto even = std::make_shared<RangeSensor>(sensor);
  std::vector<SweepRay> rays(beams);
  for (std::size_t i = 0; i < beams; ++i) {
    // `resampled` wants both counter-clockwise
    const std::size_t beam = fan.step_rad < 0.0 ? beams - 1 - i : i;
    const double first_rad =
        fan.step_rad < 0.0 ? sensor.robot_from_beam.back().theta_rad : fan.first_rad;
    even->robot_from_beam[i] = {
        fan.origin.x(), fan.origin.y(),
        wrap_angle(first_rad + static_cast<double>(i) * std::abs(fan.step_rad))};
    const Pose2& from = sensor.robot_from_beam[beam];
    const Echo echo = echo_in(reading.ranges_m[beam], sensor);
    const double range_m =
        echo == Echo::surface ? static_cast<double>(reading.ranges_m[beam]) : sensor.max_range_m;
    rays[i] = {from.position(), from.position() + range_m * direction(from.theta_rad), echo};
  }
  RangeReading evenly = reading;
  evenly.ranges_m = resampled(rays, *even);
  evenly.sensor = std::move(even);
  return evenly;
}

std::vector<RangeReading> fans_in(const RangeReading& reading) {
  constexpr std::size_t kMostLasers = 16;  // more: each beam has a place of its own
  const std::vector<Pose2>& beams = reading.sensor->robot_from_beam;
  std::vector<std::size_t> firsts = {0};
  for (std::size_t i = 1; i < beams.size(); ++i) {
    if ((beams[i].position() - beams[i - 1].position()).norm() > kSameM) firsts.push_back(i);
  }
  if (firsts.size() == 1 || firsts.size() > kMostLasers) return {as_fan(reading)};
  firsts.push_back(beams.size());
  std::vector<RangeReading> fans;
  for (std::size_t laser = 0; laser + 1 < firsts.size(); ++laser) {
    const auto from = static_cast<std::ptrdiff_t>(firsts[laser]);
    const auto to = static_cast<std::ptrdiff_t>(firsts[laser + 1]);
    RangeReading part = reading;
    part.ranges_m.assign(reading.ranges_m.begin() + from, reading.ranges_m.begin() + to);
    auto sensor = std::make_shared<RangeSensor>(*reading.sensor);
    sensor->robot_from_beam.assign(beams.begin() + from, beams.begin() + to);
    part.sensor = std::move(sensor);
    fans.push_back(as_fan(part));
  }
  return fans;
}

void require_a_range_a_beam(const RangeReading& reading) {
  const std::size_t beams = reading.sensor->robot_from_beam.size();
  if (beams > 0 && reading.ranges_m.size() == beams) return;
  throw std::invalid_argument("a reading has " + std::to_string(reading.ranges_m.size()) +
                              " ranges but its sensor has " + std::to_string(beams) + " beams");
}

}  // namespace roomatlas::io
