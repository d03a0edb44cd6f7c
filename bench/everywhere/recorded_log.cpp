// SPDX-License-Identifier: GPL-3.0-or-later
#include "recorded_log.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <stdexcept>
#include <vector>

#include "roomatlas/io/logs/mission_writer.hpp"
#include "roomatlas/io/logs/open_mission.hpp"

namespace roomatlas::bench {
namespace {

/// A sensor of which some beams are left.
struct Thinned {
  std::shared_ptr<RangeSensor> sensor;
  std::vector<std::size_t> beams;  ///< of the former
};

Thinned thinned(const RangeSensor& whole, const LogChange& change) {
  Thinned left{std::make_shared<RangeSensor>(whole), {}};
  left.sensor->robot_from_beam.clear();
  left.sensor->max_range_m = std::min(whole.max_range_m, change.max_range_m);
  for (std::size_t i = 0; i < whole.robot_from_beam.size(); ++i) {
    const Pose2& beam = whole.robot_from_beam[i];
    if (i % change.every_beam != 0) continue;
    if (std::abs(degrees(beam.theta_rad)) > change.view_deg / 2.0) continue;
    left.beams.push_back(i);
    left.sensor->robot_from_beam.push_back(beam);
  }
  return left;
}

std::vector<RangeReading> readings_of(const std::filesystem::path& file, MissionInfo& info) {
  const auto source = open_mission(file, {});
  std::vector<RangeReading> readings;
  while (auto event = source->next()) {
    if (auto* reading = std::get_if<RangeReading>(&*event)) readings.push_back(*reading);
  }
  info = source->info();
  if (readings.empty()) throw std::runtime_error(file.string() + ": has no readings");
  return readings;
}

}  // namespace

void write_changed_log(const std::filesystem::path& from, const LogChange& change,
                       const std::filesystem::path& to) {
  MissionInfo info;
  std::vector<RangeReading> readings = readings_of(from, info);
  alter_odometry(readings, change.odometry, change.seed);
  std::mt19937_64 engine(static_cast<std::uint64_t>(change.seed));
  std::normal_distribution<double> noise(0.0, 1.0);
  std::map<const RangeSensor*, Thinned> sensors;
  std::unique_ptr<MissionWriter> writer;
  for (const RangeReading& whole : readings) {
    Thinned& left = sensors[whole.sensor.get()];
    if (!left.sensor) left = thinned(*whole.sensor, change);
    RangeReading reading{whole.timestamp_s, whole.odom_from_robot, left.sensor, {}};
    for (const std::size_t beam : left.beams) {
      const float range_m = whole.ranges_m[beam];
      const bool is_echo = range_m > 0.0F && range_m < left.sensor->max_range_m;
      if (!is_echo) {
        reading.ranges_m.push_back(range_m > 0.0F ? static_cast<float>(left.sensor->max_range_m)
                                                  : range_m);
        continue;
      }
      const double noisy_m = range_m + change.range_noise_m * noise(engine);
      reading.ranges_m.push_back(static_cast<float>(std::max(0.02, noisy_m)));
    }
    if (!writer) writer = create_mission(to, *left.sensor, info.footprint);
    writer->write(OdometryStep{whole.timestamp_s, whole.odom_from_robot, 0.0, 0.0});
    writer->write(reading);
  }
  writer->finish();
}

}  // namespace roomatlas::bench
