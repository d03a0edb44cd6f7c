// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/mission/as_sonar.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "support/memory_mission.hpp"

namespace roomatlas {
namespace {

/// One sweep of a laser whose beam `i` sees `2 + i / 100` metres, as a ring hears it.
RangeReading heard_by(double first_deg, double apart_deg, int beams) {
  auto laser = std::make_shared<RangeSensor>();
  laser->kind = SensorKind::laser;
  laser->max_range_m = 20.0;
  RangeReading reading;
  for (int i = 0; i < beams; ++i) {
    laser->robot_from_beam.push_back({0.1, 0.0, wrap_angle(radians(first_deg + i * apart_deg))});
    reading.ranges_m.push_back(2.0F + static_cast<float>(i) / 100.0F);
  }
  reading.sensor = laser;
  const auto ring =
      as_sonar(std::make_unique<test::MemoryMission>(std::vector<MissionEvent>{reading}), {}, 10.0);
  return std::get<RangeReading>(*ring->next());
}

TEST(AsSonar, EachConeHearsTheLeastRangeOfItsBeams) {
  const RangeReading heard = heard_by(-179.5, 1.0, 360);
  ASSERT_EQ(heard.sensor->kind, SensorKind::sonar);
  ASSERT_EQ(heard.ranges_m.size(), 16U);
  for (std::size_t cone = 0; cone < heard.ranges_m.size(); ++cone) {
    const double bearing_deg = degrees(heard.sensor->robot_from_beam[cone].theta_rad);
    double least_m = 100.0;
    for (int i = 0; i < 360; ++i) {
      const double off_deg = std::abs(std::remainder(-179.5 + i - bearing_deg, 360.0));
      if (off_deg <= 10.0) least_m = std::min(least_m, 2.0 + i / 100.0);
    }
    EXPECT_NEAR(heard.ranges_m[cone], least_m, 1e-5) << bearing_deg;
  }
}

// Guided fuzzing found it: beams on both sides of a rear cone and none inside ended the program.
TEST(AsSonar, AConeThatNoBeamLiesInIsNone) {
  const RangeReading heard = heard_by(119.0, 22.0, 2);  // 119 and 141 degrees, around 130
  EXPECT_EQ(heard.ranges_m.size(), 0U);
  EXPECT_EQ(heard_by(125.0, 10.0, 2).sensor->kind, SensorKind::sonar);
}

}  // namespace
}  // namespace roomatlas
