// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/mission_bag.hpp"

#include "bags/ros1_md5.hpp"
#include "io/bags/read_bag.hpp"
#include "io/bags/small_mission.hpp"
#include "io/mission_log.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace roomatlas::test {
namespace {

constexpr const char* kRecordings[] = {"m.bag", "m.mcap", "m.db3", "m"};

/// As a CARMEN log and a recording hold it: nothing within range, and no measurement.
void expect_range(float read_m, float simulated_m, double max_range_m) {
  if (!std::isfinite(simulated_m) || simulated_m <= 0.0F) {
    EXPECT_FALSE(std::isfinite(read_m) && read_m > 0.0F);
  } else if (simulated_m >= static_cast<float>(max_range_m)) {
    EXPECT_EQ(read_m, static_cast<float>(max_range_m));
  } else {
    EXPECT_EQ(read_m, simulated_m);
  }
}

void expect_same(const ReadLog& log, const std::vector<SimulatedStep>& steps) {
  const RangeSensor& sensor = *steps[0].reading.sensor;
  ASSERT_EQ(log.readings.size(), steps.size());
  ASSERT_EQ(log.true_poses.size(), steps.size());
  ASSERT_EQ(log.info.sensors.size(), 1U);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const RangeReading& reading = log.readings[i];
    EXPECT_EQ(reading.timestamp_s, steps[i].reading.timestamp_s);
    EXPECT_EQ(reading.odom_from_robot, steps[i].odometry.odom_from_robot);
    EXPECT_EQ(log.true_poses[i].timestamp_s, steps[i].truth.timestamp_s);
    EXPECT_EQ(log.true_poses[i].world_from_robot, steps[i].truth.world_from_robot);
    ASSERT_EQ(reading.ranges_m.size(), sensor.robot_from_beam.size());
    for (std::size_t beam = 0; beam < reading.ranges_m.size(); ++beam) {
      expect_range(reading.ranges_m[beam], steps[i].reading.ranges_m[beam], sensor.max_range_m);
    }
  }
  const RangeSensor& read = *log.info.sensors[0];
  EXPECT_EQ(read.kind, sensor.kind);
  EXPECT_EQ(read.max_range_m, static_cast<double>(static_cast<float>(sensor.max_range_m)));
  EXPECT_EQ(read.half_cone_rad, sensor.half_cone_rad);
  ASSERT_EQ(read.robot_from_beam.size(), sensor.robot_from_beam.size());
  for (std::size_t i = 0; i < read.robot_from_beam.size(); ++i) {  // a scan's add up from the first
    const Pose2& beam = sensor.robot_from_beam[i];
    EXPECT_EQ(read.robot_from_beam[i].position(), beam.position());
    EXPECT_NEAR(read.robot_from_beam[i].theta_rad, beam.theta_rad, 1e-14);
  }
}

TEST(MissionBag, OfALaserReadsBackToTheSameBitsFromEveryContainer) {
  const std::vector<SimulatedStep> steps = mission_of(SensorKind::laser);
  ASSERT_GT(steps.size(), 50U);
  for (const std::string name : kRecordings) {
    SCOPED_TRACE(name);
    const TemporaryFolder folder;
    write(folder / name, steps);
    expect_same(read_log(folder / name), steps);
  }
}

/// By less than a track keeps, so that both times overlap; and by more than the whole mission.
TEST(MissionBag, OfALogWhoseClockIsSetBackKeepsItsOrderAndItsMounts) {
  for (const double back_s : {0.7, 3.0, 300.0}) {
    std::vector<SimulatedStep> steps = mission_of(SensorKind::laser);
    for (std::size_t i = steps.size() / 2; i < steps.size(); ++i) {
      steps[i].odometry.timestamp_s -= back_s;
      steps[i].reading.timestamp_s -= back_s;
      steps[i].truth.timestamp_s -= back_s;
    }
    for (const std::string name : kRecordings) {
      SCOPED_TRACE(name + " by " + std::to_string(back_s));
      const TemporaryFolder folder;
      write(folder / name, steps);
      const ReadLog log = read_log(folder / name);
      expect_same(log, steps);
      EXPECT_NE(bags::text_of(log.info.issues).find("1 times the clock"), std::string::npos);
    }
  }
}

TEST(MissionBag, OfARingOfSonarsReadsBackToTheSameBitsFromEveryContainer) {
  const std::vector<SimulatedStep> steps = mission_of(SensorKind::sonar);
  for (const std::string name : kRecordings) {
    SCOPED_TRACE(name);
    const TemporaryFolder folder;
    write(folder / name, steps);
    expect_same(read_log(folder / name), steps);
  }
}

/// The same bits, but that a text has 0 for no measurement.
void expect_same_logs(const ReadLog& text, const ReadLog& bag) {
  ASSERT_EQ(text.readings.size(), bag.readings.size());
  ASSERT_EQ(text.true_poses.size(), bag.true_poses.size());
  EXPECT_EQ(text.info.sensors.at(0)->robot_from_beam, bag.info.sensors.at(0)->robot_from_beam);
  EXPECT_EQ(text.info.sensors.at(0)->half_cone_rad, bag.info.sensors.at(0)->half_cone_rad);
  EXPECT_EQ(text.info.sensors.at(0)->max_range_m, bag.info.sensors.at(0)->max_range_m);
  EXPECT_EQ(text.info.path_length_m, bag.info.path_length_m);
  int ranges_that_differ = 0;
  for (std::size_t i = 0; i < text.readings.size(); ++i) {
    EXPECT_EQ(text.readings[i].timestamp_s, bag.readings[i].timestamp_s);
    EXPECT_EQ(text.readings[i].odom_from_robot, bag.readings[i].odom_from_robot);
    EXPECT_EQ(text.true_poses[i].world_from_robot, bag.true_poses[i].world_from_robot);
    for (std::size_t beam = 0; beam < text.readings[i].ranges_m.size(); ++beam) {
      const float of_text = text.readings[i].ranges_m[beam];
      const float of_bag = bag.readings[i].ranges_m[beam];
      const bool is_same = of_text == 0.0F ? std::isnan(of_bag) : of_text == of_bag;
      if (!is_same) ++ranges_that_differ;
    }
  }
  EXPECT_EQ(ranges_that_differ, 0);
}

TEST(MissionBag, OfEveryShippedWorldReadsBackAsItsCarmenLog) {
  int worlds = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(Path(ROOMATLAS_SOURCE_DIR) / "data/worlds")) {
    if (entry.path().extension() != ".geojson") continue;
    SCOPED_TRACE(entry.path().filename().string());
    ++worlds;
    for (const SensorKind kind : {SensorKind::laser, SensorKind::sonar}) {
      const TemporaryFolder folder;
      const std::vector<SimulatedStep> steps = explored(read_world(entry.path(), {}), kind);
      write(folder / "m.clf", steps);
      write(folder / "m.mcap", steps);
      write(folder / "m.bag", steps);
      const ReadLog text = read_log(folder / "m.clf");
      expect_same_logs(text, read_log(folder / "m.mcap"));
      expect_same_logs(text, read_log(folder / "m.bag"));
    }
  }
  EXPECT_GE(worlds, 7);
}

TEST(MissionBag, IsTheSameBytesTwice) {
  const std::vector<SimulatedStep> steps = mission_of(SensorKind::laser);
  const TemporaryFolder folder;
  for (const std::string ending : {".bag", ".mcap", ".db3"}) {
    write(folder / ("a" + ending), steps);
    write(folder / ("b" + ending), steps);
    EXPECT_TRUE(bytes_of(folder / ("a" + ending)) == bytes_of(folder / ("b" + ending))) << ending;
  }
}

/// A laser as the rings of robots' logs are not: its beams clockwise, behind the robot, and few.
RangeSensor rear_laser() {
  RangeSensor laser;
  laser.max_range_m = 12.0;
  for (int i = 0; i < 9; ++i) {
    laser.robot_from_beam.push_back({-0.2, 0.05, wrap_angle(kPi + 1.0 - 0.25 * i)});
  }
  return laser;
}

TEST(MissionBag, SeveralLasersShareATopicAndKeepTheirMounts) {
  const auto front = std::make_shared<RangeSensor>(front_laser({}));
  const auto rear = std::make_shared<RangeSensor>(rear_laser());
  for (const std::string name : {"m.mcap", "m.bag", "m.clf"}) {
    SCOPED_TRACE(name);
    const TemporaryFolder folder;
    const auto writer = create_mission(folder / name, *front, {});
    for (int i = 0; i < 30; ++i) {
      const double time_s = 1000.0 + 0.1 * i;
      const Pose2 pose{0.1 * i, 0.0, 0.01 * i};
      writer->write(OdometryStep{time_s, pose, 0.0, 0.0});
      writer->write(RangeReading{time_s, pose, front, std::vector<float>(181, 2.5F)});
      writer->write(RangeReading{time_s, pose, rear, {1, 2, 3, 4, 5, 6, 7, 8, 9}});
    }
    writer->finish();
    const ReadLog log = read_log(folder / name);
    ASSERT_EQ(log.readings.size(), 60U);
    ASSERT_EQ(log.info.sensors.size(), 2U);
    for (const RangeReading& reading : log.readings) {
      const RangeSensor& sensor = *reading.sensor;
      if (sensor.robot_from_beam.size() == 181) continue;
      ASSERT_EQ(sensor.robot_from_beam.size(), 9U);
      for (std::size_t i = 0; i < 9; ++i) {  // whichever way round: the same rays
        const auto as_written = static_cast<std::size_t>(std::lround(reading.ranges_m[i])) - 1;
        const Pose2& beam = rear->robot_from_beam[as_written];
        EXPECT_NEAR(sensor.robot_from_beam[i].x_m, beam.x_m, 1e-9);
        EXPECT_NEAR(sensor.robot_from_beam[i].y_m, beam.y_m, 1e-9);
        EXPECT_NEAR(wrap_angle(sensor.robot_from_beam[i].theta_rad - beam.theta_rad), 0.0, 2e-6);
      }
    }
  }
}

TEST(MissionBag, BeamsThatAreNotEvenlySpacedAreMadeSo) {
  auto uneven = std::make_shared<RangeSensor>();
  uneven->max_range_m = 20.0;
  std::vector<float> ranges_m;
  for (int i = 0; i < 91; ++i) {  // on a wall straight ahead
    const double bearing_rad = -0.7 + 1.4 * i / 90.0 + 0.004 * std::sin(0.1 * i);
    uneven->robot_from_beam.push_back({0.1, 0.0, bearing_rad});
    ranges_m.push_back(static_cast<float>(3.0 / std::cos(bearing_rad)));
  }
  for (const std::string name : {"m.mcap", "m.clf"}) {
    const TemporaryFolder folder;
    const auto writer = create_mission(folder / name, *uneven, {});
    for (int i = 0; i < 5; ++i) {
      writer->write(OdometryStep{100.0 + i, {0.1 * i, 0, 0}, 0.0, 0.0});
      writer->write(RangeReading{100.0 + i, {0.1 * i, 0, 0}, uneven, ranges_m});
    }
    writer->finish();
    const ReadLog log = read_log(folder / name);
    ASSERT_EQ(log.readings.size(), 5U) << name;
    const RangeReading& reading = log.readings[2];
    for (std::size_t i = 1; i < 90; ++i) {
      const double bearing_rad = reading.sensor->robot_from_beam[i].theta_rad;
      EXPECT_NEAR(static_cast<double>(reading.ranges_m[i]) * std::cos(bearing_rad), 3.0, 1e-3);
    }
  }
}

TEST(MissionBag, ATimeThatNoStampHoldsIsRefused) {
  const TemporaryFolder folder;
  const auto writer = create_mission(folder / "m.mcap", front_laser({}), {});
  EXPECT_THROW(writer->write(TruePose{-1.0, {}}), InputError);
  EXPECT_THROW(writer->write(TruePose{std::nan(""), {}}), InputError);
  EXPECT_THROW(writer->write(TruePose{1e10, {}}), InputError);
  EXPECT_THROW((void)create_mission(folder / "m.txt", front_laser({}), {}), InputError);
}

/// The sums that ROS 1's own packages have for these types.
TEST(MissionBag, ItsDefinitionsAreRos1s) {
  const auto sum = [](const std::string& type) {
    return io::ros1_md5(type, io::definition_of(type, io::BagEncoding::ros1));
  };
  EXPECT_EQ(sum("sensor_msgs/LaserScan"), "90c7ef2dc6895d81024acba2ac42f369");
  EXPECT_EQ(sum("sensor_msgs/Range"), "c005c34273dc426c67a020a87bc24148");
  EXPECT_EQ(sum("nav_msgs/Odometry"), "cd5e73d190d741a2f92e81eda573aca7");
  EXPECT_EQ(sum("tf2_msgs/TFMessage"), "94810edda583a504dfda3829e70d7eec");
  EXPECT_EQ(sum("geometry_msgs/PoseStamped"), "d3812c3cbc69362b77dc0b19b345f8f5");
}

}  // namespace
}  // namespace roomatlas::test
