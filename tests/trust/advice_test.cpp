// SPDX-License-Identifier: GPL-3.0-or-later
#include "advice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "roomatlas/loops/visit_graph.hpp"
#include "roomatlas/solve/optimize.hpp"

namespace roomatlas {
namespace {

constexpr AsrId kVisits = 10;

/// Ten rooms in a row around a bend, one visit each, told apart by a hundred from the visits'
/// numbers; each 5 m from the last.
Assembly row_of_rooms() {
  Assembly assembly;
  assembly.correction.model = "se2";
  Pose2 at;
  for (AsrId id = 1; id <= kVisits; ++id) {
    assembly.graph.vertices.push_back({id, 100 + id});
    assembly.room_of_asr[id] = 100 + id;
    AsrCorrection asr;
    asr.asr = id;
    asr.building_from_asr = at;
    assembly.correction.asrs.push_back(asr);
    at = at * Pose2{5.0, 0.0, radians(36.0)};
  }
  for (AsrId id = 1; id < kVisits; ++id) {
    PassageEdge edge;
    edge.from = id;
    edge.to = id + 1;
    edge.from_from_to = {5.0, 0.0, radians(36.0)};
    edge.path_length_m = 5.0;
    add_edge(assembly.graph, edge);
  }
  return assembly;
}

Door door_between_rooms(RoomId a, RoomId b, const Point2& at) {
  return door_between({at, at + Point2(0.9, 0.0)}, a, b);
}

TEST(Advice, AnOpenChainIsToBeDrivenAgain) {
  const std::vector<Advice> advice = advice_on(row_of_rooms(), {});
  ASSERT_FALSE(advice.empty());
  EXPECT_LE(advice.size(), 3U);
  for (const Advice& one : advice) {
    EXPECT_LT(one.place_after_m, one.place_before_m);
    EXPECT_GT(one.drive_m, 0.0);
    EXPECT_EQ(one.from_room, 100 + one.from);
    EXPECT_EQ(one.to_room, 100 + one.to);
  }
  for (std::size_t i = 1; i < advice.size(); ++i) {
    EXPECT_NE(words(advice[i]), words(advice[i - 1]));
    EXPECT_EQ(advice[i].place_before_m, advice[i - 1].place_after_m);
  }
}

TEST(Advice, ADoorThatClosesTheRoundIsWorthMoreThanTheRoundAgain) {
  Assembly assembly = row_of_rooms();
  const Point2 at = assembly.correction.asrs.front().building_from_asr.position();
  assembly.doors.push_back(door_between_rooms(101, 110, at));
  const std::vector<Advice> advice = advice_on(assembly, {});
  ASSERT_FALSE(advice.empty());
  EXPECT_EQ(advice[0].kind, AdviceKind::use_door);
  EXPECT_EQ(words(advice[0]),
            "drive through the door between rooms 101 and 110, which has not been used");
  assembly.doors[0].kind = DoorKind::window;
  EXPECT_NE(advice_on(assembly, {})[0].kind, AdviceKind::use_door);
}

TEST(Advice, WhatADoorIsSaidToGainIsWhatASolveWithTheDriveFinds) {
  Assembly assembly = row_of_rooms();
  const AsrCorrection& first = assembly.correction.asrs.front();
  const AsrCorrection& last = assembly.correction.asrs.back();
  const Point2 at = first.building_from_asr.position();
  assembly.doors.push_back(door_between_rooms(101, 110, at));
  const Advice advice = advice_on(assembly, {}).at(0);

  const CorrectOptions options;
  PassageEdge drive;  // from the first room to the last, as long as both are from the door
  drive.from = 1;
  drive.to = kVisits;
  const Point2 pivot = assembly.doors[0].frame_from_pivot.position();
  drive.from_from_to = inverse(first.building_from_asr) * last.building_from_asr;
  drive.path_length_m = (first.building_from_asr.position() - pivot).norm() +
                        (last.building_from_asr.position() - pivot).norm();
  PassageEdge doorway;
  doorway.source = EdgeSource::recognised;
  // the drive begins and ends in visits of its own, each tied to one that was there
  PoseGraph graph =
      held_visits_of(assembly.graph, assembly.closures, assembly.correction, options).measured;
  const auto tie = [&](std::int32_t visit, std::int64_t id) {
    graph.ids.push_back(id);
    graph.guess.push_back(graph.guess[static_cast<std::size_t>(visit)]);
    const auto added = static_cast<std::int32_t>(graph.ids.size()) - 1;
    graph.edges.push_back(
        {visit, added, EdgeKind::trusted, {}, information_of(doorway, options), 0.0});
    return added;
  };
  const std::int32_t begin = tie(0, 1001);
  const std::int32_t end = tie(static_cast<std::int32_t>(kVisits) - 1, 1002);
  graph.edges.push_back(
      {begin, end, EdgeKind::odometry, drive.from_from_to, information_of(drive, options), 0.0});
  OptimizeOptions wanted;
  wanted.covariance = true;
  const PoseCovariance solved = optimize(graph, wanted).covariance;
  double largest_rad2 = 0.0;
  double largest_m2 = 0.0;
  for (std::size_t i = 0; i < kVisits; ++i) {
    const Eigen::Matrix3d& of_node = solved.of_node[i];
    largest_rad2 = std::max(largest_rad2, of_node(2, 2));
    const double middle = (of_node(0, 0) + of_node(1, 1)) / 2.0;
    largest_m2 = std::max(
        largest_m2, middle + std::hypot((of_node(0, 0) - of_node(1, 1)) / 2.0, of_node(0, 1)));
  }
  EXPECT_NEAR(advice.place_after_m, std::sqrt(largest_m2), 1e-6);
  EXPECT_NEAR(advice.heading_after_deg, degrees(std::sqrt(largest_rad2)), 1e-5);
}

TEST(Advice, WhereAllIsHeldNothingIsSaid) {
  Assembly assembly = row_of_rooms();
  Closure closure;
  closure.verdict = ClosureVerdict::accepted;
  closure.match.information = Eigen::Vector3d(1e4, 1e4, 1e6).asDiagonal();
  for (AsrId id = 2; id <= kVisits; ++id) {  // each is seen from the first as well as can be
    closure.from = 1;
    closure.to = id;
    closure.match.first_from_second =
        assembly.correction.asrs[static_cast<std::size_t>(id) - 1].building_from_asr;
    assembly.closures.push_back(closure);
    PassageEdge edge;
    edge.from = 1;
    edge.to = id;
    edge.source = EdgeSource::matched;
    edge.from_from_to = closure.match.first_from_second;
    edge.information = closure.match.information;
    add_edge(assembly.graph, edge);
  }
  EXPECT_TRUE(advice_on(assembly, {}).empty());
  EXPECT_TRUE(advice_on({}, {}).empty());
}

TEST(Advice, ItsWordsNameRoomsAndTheWayBetweenThem) {
  Advice advice;
  advice.from_room = 3;
  advice.to_room = 4;
  EXPECT_EQ(words(advice), "drive once more through the passage between rooms 3 and 4");
  advice.by_door = true;
  EXPECT_EQ(words(advice), "drive once more through the door between rooms 3 and 4");
  advice.kind = AdviceKind::drive_again;
  EXPECT_EQ(words(advice), "drive once more from room 3 to room 4");
  advice.to_room = 3;
  EXPECT_EQ(words(advice), "drive once more through room 3");
}

TEST(Advice, OfSonarsSpeaksOfWhatWasDrawn) {
  Assembly assembly = row_of_rooms();
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (AsrId id = 1; id <= kVisits; ++id) {
    for (int draw = 0; draw < 400; ++draw) {
      const double spread_m = id < kVisits ? 0.02 : 0.5;
      assembly.moves.drawn[id].push_back({spread_m * normal(random), 0.02 * normal(random), 0.0});
    }
  }
  const std::vector<Advice> advice = advice_on(assembly, {});
  ASSERT_FALSE(advice.empty());
  EXPECT_NEAR(advice[0].place_before_m, 0.5, 0.05);
  EXPECT_EQ(advice[0].to, kVisits);
  EXPECT_LT(advice[0].place_after_m, 0.5 * advice[0].place_before_m);
}

}  // namespace
}  // namespace roomatlas
