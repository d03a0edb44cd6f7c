// SPDX-License-Identifier: GPL-3.0-or-later
// Two missions through two rooms side by side, drawn by hand: what is counted is known.
#include "roomatlas/evaluate/mission_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "roomatlas/asr/memory_store.hpp"

namespace roomatlas {
namespace {

Ring ring_about(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

/// In a frame that lies at (10, 20) and is turned a right angle, so that poses matter.
const Pose2 kBuildingFromAsr{10.0, 20.0, kPi / 2.0};

/// @param free of the building
Asr visit(AsrId id, double start_s, double end_s, const Ring& free, const Segment2& wall) {
  const Pose2 asr_from_building = inverse(kBuildingFromAsr);
  Asr asr;
  asr.id = id;
  asr.start_s = start_s;
  asr.end_s = end_s;
  for (const Point2& corner : free) asr.outline_asr.outer.push_back(asr_from_building * corner);
  asr.walls.push_back({{asr_from_building * wall.a, asr_from_building * wall.b}, {true}});
  asr.path = {{start_s, {}, {}}, {end_s, {1.5, 0.0, 0.0}, {}}};
  return asr;
}

class MissionFiguresOfTwo : public ::testing::Test {
 protected:
  MissionFiguresOfTwo() {
    plan_.rooms.resize(2);
    plan_.rooms[0].id = 7;
    plan_.rooms[0].parts = {{ring_about(0.0, 0.0, 4.0, 4.0), {}}};
    plan_.rooms[0].asrs = {1, 2, 4};
    plan_.rooms[1].id = 3;
    plan_.rooms[1].parts = {{ring_about(4.0, 0.0, 8.0, 4.0), {}}};
    plan_.rooms[1].asrs = {3, 5};
    const Ring first = ring_about(0.0, 0.0, 4.0, 4.0);
    const Ring second = ring_about(4.0, 0.0, 8.0, 4.0);
    const Segment2 south{{0.0, 0.0}, {4.0, 0.0}};
    const Segment2 south_of_second{{4.0, 0.0}, {8.0, 0.0}};
    source_.asrs = {visit(1, 10.0, 20.0, first, south), visit(2, 20.0, 30.0, first, south),
                    visit(3, 30.0, 40.0, second, south_of_second),
                    visit(4, 40.0, 50.0, first, south),
                    // The other mission: half of one room, its wall 0.05 m off.
                    visit(5, 5.0, 8.0, ring_about(4.0, 0.0, 6.0, 4.0), {{4.0, 0.05}, {6.0, 0.05}})};
    for (const Asr& asr : source_.asrs) placement_[asr.id] = kBuildingFromAsr;
    members_.resize(2);
    members_[0] = {"a.clf", SensorKind::laser, 1, 4, true};
    members_[1] = {"b.clf", SensorKind::sonar, 5, 5};
  }

  [[nodiscard]] MissionsFigures figures(const std::vector<Closure>& closures = {}) const {
    return mission_figures(source_, placement_, members_, closures, plan_);
  }

  FloorPlan plan_;
  MemoryStore source_;
  Placement placement_;
  std::vector<MemberMission> members_;
};

TEST_F(MissionFiguresOfTwo, TellWhoWasInWhichRoomWhen) {
  const MissionsFigures figures = this->figures();
  ASSERT_EQ(figures.missions.size(), 2U);
  const MissionFigures& a = figures.missions[0];
  EXPECT_EQ(a.name, "a.clf");
  EXPECT_DOUBLE_EQ(a.first_s, 10.0);
  EXPECT_DOUBLE_EQ(a.last_s, 50.0);
  EXPECT_DOUBLE_EQ(a.path_length_m, 6.0);
  ASSERT_EQ(a.rooms.size(), 2U);
  EXPECT_EQ(a.rooms[0].room, 3);
  EXPECT_EQ(a.rooms[0].visits, 1);
  EXPECT_DOUBLE_EQ(a.rooms[0].first_s, 30.0);
  EXPECT_DOUBLE_EQ(a.rooms[0].last_s, 40.0);
  EXPECT_EQ(a.rooms[1].room, 7);
  EXPECT_EQ(a.rooms[1].visits, 2);  // two pieces in turn are one visit
  EXPECT_DOUBLE_EQ(a.rooms[1].first_s, 10.0);
  EXPECT_DOUBLE_EQ(a.rooms[1].last_s, 50.0);
  const MissionFigures& b = figures.missions[1];
  ASSERT_EQ(b.rooms.size(), 1U);
  EXPECT_EQ(b.rooms[0].room, 3);
  EXPECT_DOUBLE_EQ(b.rooms[0].first_s, 5.0);
  EXPECT_DOUBLE_EQ(b.rooms[0].last_s, 8.0);
}

TEST_F(MissionFiguresOfTwo, CountTheFloorThatEachSawOnce) {
  const MissionsFigures figures = this->figures();
  EXPECT_NEAR(figures.floor_m2, 32.0, 1e-9);
  EXPECT_NEAR(figures.missions[0].seen_m2, 32.0, 1e-9);
  EXPECT_NEAR(figures.missions[1].seen_m2, 8.0, 1e-9);
  EXPECT_NEAR(figures.missions[1].rooms[0].seen_m2, 8.0, 1e-9);
  EXPECT_NEAR(figures.missions[1].rooms[0].floor_m2, 16.0, 1e-9);
}

TEST_F(MissionFiguresOfTwo, MeasureWallsAgainstThoseOfTheOthersInTheSameRoom) {
  const MissionsFigures figures = this->figures();
  EXPECT_NEAR(figures.missions[1].walls_rms_m, 0.05, 1e-9);
  EXPECT_NEAR(figures.missions[1].walls_compared_m, 2.0, 1e-9);
  // Of mission a the half of its wall in the second room, and a little beyond the other's end.
  EXPECT_GE(figures.missions[0].walls_compared_m, 2.0);
  EXPECT_LE(figures.missions[0].walls_compared_m, 2.35);
  plan_.rooms[0].asrs.push_back(5);
  plan_.rooms[1].asrs = {3};
  const MissionsFigures apart = this->figures();
  EXPECT_TRUE(std::isnan(apart.missions[1].walls_rms_m) || apart.missions[1].walls_compared_m < 0.4)
      << "walls of another room are no walls of this one";
}

TEST_F(MissionFiguresOfTwo, MeasureMatchesBetweenMissionsAlone) {
  const auto closure = [](AsrId from, AsrId to, const Pose2& match, ClosureVerdict verdict) {
    Closure one;
    one.from = from;
    one.to = to;
    one.match.first_from_second = match;
    one.verdict = verdict;
    return one;
  };
  const MissionsFigures figures = this->figures({
      closure(1, 4, {5.0, 0.0, 0.0}, ClosureVerdict::accepted),  // of one mission
      closure(3, 5, {0.03, 0.0, radians(1.0)}, ClosureVerdict::accepted),
      closure(5, 4, {0.0, 0.04, 0.0}, ClosureVerdict::accepted),
      closure(1, 5, {9.0, 0.0, 0.0}, ClosureVerdict::contradicted),
  });
  ASSERT_EQ(figures.pairs.size(), 1U);
  EXPECT_EQ(figures.pairs[0].first, 0U);
  EXPECT_EQ(figures.pairs[0].second, 1U);
  EXPECT_EQ(figures.pairs[0].accepted, 2);
  EXPECT_EQ(figures.pairs[0].refused, 1);
  EXPECT_NEAR(figures.pairs[0].rms_m, std::sqrt((0.03 * 0.03 + 0.04 * 0.04) / 2.0), 1e-12);
  EXPECT_NEAR(figures.pairs[0].rms_deg, std::sqrt(0.5), 1e-9);
}

}  // namespace
}  // namespace roomatlas
