// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "roomatlas/mission/part_of_mission.hpp"
#include "support/memory_mission.hpp"

namespace roomatlas::test {
namespace {

/// Ten readings, a metre and a second apart, each with its true pose before it.
MemoryMission ten_metres() {
  std::vector<MissionEvent> events;
  const auto sensor = std::make_shared<const RangeSensor>();
  for (int i = 0; i < 10; ++i) {
    const Pose2 pose{static_cast<double>(i), 0.0, 0.0};
    events.emplace_back(TruePose{100.0 + i, pose});
    events.emplace_back(RangeReading{100.0 + i, pose, sensor, {}, 0.0});
  }
  return MemoryMission(std::move(events));
}

std::vector<double> times_of(MissionSource& mission, bool of_truth) {
  std::vector<double> times_s;
  while (const auto event = mission.next()) {
    if (std::holds_alternative<TruePose>(*event) != of_truth) continue;
    times_s.push_back(std::visit([](const auto& one) { return one.timestamp_s; }, *event));
  }
  return times_s;
}

TEST(PartOfMission, HandsOutItsReadingsAlone) {
  MemoryMission whole = ten_metres();
  PartOfMission part(whole, {2, 3, 5});
  EXPECT_EQ(times_of(part, false), (std::vector<double>{103.0, 104.0, 105.0}));
}

TEST(PartOfMission, HandsOutTruthOnceOverAllParts) {
  std::vector<double> times_s;
  for (const MissionPart& piece : {MissionPart{1, 0, 3}, MissionPart{2, 4, 1000}}) {
    MemoryMission whole = ten_metres();
    PartOfMission part(whole, piece);
    for (const double time_s : times_of(part, true)) times_s.push_back(time_s);
  }
  std::vector<double> all;
  for (int i = 0; i < 10; ++i) all.push_back(100.0 + i);
  EXPECT_EQ(times_s, all);
}

TEST(PartOfMission, TellsOfItselfAndNotOfTheWhole) {
  MemoryMission whole = ten_metres();
  PartOfMission part(whole, {2, 3, 5});
  (void)times_of(part, false);
  EXPECT_EQ(part.info().file, "memory.clf#2");
  EXPECT_EQ(part.info().readings, 3);
  EXPECT_EQ(part.info().path_length_m, 2.0);
  EXPECT_EQ(part.info().first_timestamp_s, 103.0);
  EXPECT_EQ(part.info().last_timestamp_s, 105.0);
}

TEST(PartOfMission, IsTheMissionWhereItIsTheWhole) {
  MemoryMission whole = ten_metres();
  PartOfMission part(whole, {});
  EXPECT_EQ(times_of(part, false).size(), 10U);
  EXPECT_EQ(part.info().file, "memory.clf");
}

}  // namespace
}  // namespace roomatlas::test
