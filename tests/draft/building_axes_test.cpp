// SPDX-License-Identifier: GPL-3.0-or-later
// However a mission's frame lies, and even if its end is missing, the rooms are the same.
#include "roomatlas/draft/building_axes.hpp"

#include <gtest/gtest.h>

#include "known_poses.hpp"
#include "roomatlas/planar/union.hpp"

namespace roomatlas {
namespace {

/// The rooms of a mission whose frame lies otherwise, in the frame that it had.
std::vector<PlacedOutline> rooms_of(const test::KnownMission& mission, const Pose2& placed_at) {
  const Placement placement{{1, placed_at}};
  const Pose2 axes = axes_from_building(mission.store, placement, {});
  const BuildingEvidence evidence =
      gather_evidence(mission.store, moved(placement, axes), {}, {}, {});
  return moved(mapped_building_of(draft_building(evidence, {}), evidence, {}),
               inverse(placed_at) * inverse(axes))
      .outlines;
}

constexpr double kSame = 0.95;  // of two rooms that they have in common

/// As many rooms, of the same numbers and shapes.
void expect_same(const std::vector<PlacedOutline>& rooms,
                 const std::vector<PlacedOutline>& expected) {
  ASSERT_EQ(rooms.size(), expected.size());
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    EXPECT_EQ(rooms[i].room, expected[i].room);
    EXPECT_GT(overlap_area({rooms[i].outline}, {expected[i].outline}),
              kSame * std::max(area(rooms[i].outline), area(expected[i].outline)))
        << "room " << rooms[i].room;
  }
}

class EitherSensor : public testing::TestWithParam<SensorKind> {};
INSTANTIATE_TEST_SUITE_P(BuildingAxes, EitherSensor,
                         testing::Values(SensorKind::laser, SensorKind::sonar));

TEST_P(EitherSensor, DrawsTheSameHoweverTheMissionsFrameLies) {
  const auto mission = test::eight_rooms(GetParam(), {}, 3);
  const std::vector<PlacedOutline> rooms = rooms_of(mission, {});
  ASSERT_GE(rooms.size(), 8u);
  for (const double turn_deg : {23.0, -110.0}) {
    SCOPED_TRACE(turn_deg);
    expect_same(rooms_of(mission, {31.7, -12.3, radians(turn_deg)}), rooms);
  }
}

TEST(BuildingAxes, WallsRunAlongThem) {
  const Pose2 tilted{4.0, 5.0, radians(17.0)};
  const auto mission = test::eight_rooms(SensorKind::laser, tilted);
  const Pose2 axes = axes_from_building(mission.store, {{1, Pose2{}}}, {});
  const double off_rad = 4.0 * (axes.theta_rad + tilted.theta_rad);
  EXPECT_NEAR(wrap_angle(off_rad) / 4.0, 0.0, radians(0.1));
  const Pose2 first = axes * mission.store.get(1, AsrDetail::path).path.front().asr_from_robot;
  EXPECT_NEAR(first.position().norm(), 0.0, 1e-9);
  EXPECT_LE(std::abs(first.theta_rad), radians(45.1));
}

TEST(BuildingAxes, AMissionWithoutItsLastTwentiethHasTheSameRooms) {
  auto mission = test::eight_rooms(SensorKind::laser, {}, 3);
  const std::vector<PlacedOutline> rooms = rooms_of(mission, {});
  Asr asr = mission.store.get(1, AsrDetail::readings);
  asr.path.resize(asr.path.size() * 19 / 20);
  asr.readings.resize(asr.path.size());
  mission.store.asrs = {asr};
  expect_same(rooms_of(mission, {}), rooms);
}

}  // namespace
}  // namespace roomatlas
