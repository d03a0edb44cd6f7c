// SPDX-License-Identifier: GPL-3.0-or-later
// Each figure on two rooms whose errors are known.
#include "roomatlas/evaluate/self_consistency.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "evaluate/four_rooms.hpp"

namespace roomatlas {
namespace {

using namespace test;

/// A room of 4 m x 3 m in its own frame, seen from its middle by one sweep.
Asr seen_room(AsrId id) {
  Asr asr;
  asr.id = id;
  asr.outline_asr = rectangle(0, 0, 4, 3);
  const Ring& ring = asr.outline_asr.outer;
  asr.walls = {{{ring[0], ring[1], ring[2], ring[3], ring[0]}, {true, true, true, true}}};
  auto sensor = std::make_shared<RangeSensor>();
  sensor->max_range_m = 20.0;
  RangeReading reading;
  for (int i = 0; i < 360; ++i) {
    const Pose2 beam{0, 0, wrap_angle(radians(i))};
    const Segment2 ray{{2, 1.5}, Point2(2, 1.5) + 20.0 * direction(beam.theta_rad)};
    double nearest = 1.0;
    for (std::size_t e = 0; e < 4; ++e) {
      nearest = std::min(nearest, crossing_fraction(ray, {ring[e], ring[(e + 1) % 4]}).value_or(1));
    }
    sensor->robot_from_beam.push_back(beam);
    reading.ranges_m.push_back(static_cast<float>(20.0 * nearest));
  }
  reading.sensor = sensor;
  for (int sweep = 0; sweep < 12; ++sweep) {
    asr.path.push_back({static_cast<double>(sweep), {2, 1.5, 0}, {2, 1.5, 0}});
    asr.readings.push_back(reading);
  }
  return asr;
}

Exit exit_at(PassageKind kind, bool is_entry, const Pose2& pivot, AsrId neighbor) {
  const Segment2 jambs{pivot * Point2(0, 0.5), pivot * Point2(0, -0.5)};
  return {{pivot, 1.0, jambs}, kind, is_entry, neighbor, 0.0};
}

/// Two rooms with a wall of 0.2 m between them and a door in it.
std::vector<AsrEvidence> two_rooms(PassageKind kind = PassageKind::doorway, AsrId id = 1) {
  Asr first = seen_room(id);
  Asr second = seen_room(id + 1);
  first.exits = {exit_at(kind, false, {4.1, 1, 0}, id + 1)};
  second.exits = {exit_at(kind, true, {-0.1, 1, wrap_angle(kPi)}, id)};
  return {evidence_of(first, {}), evidence_of(second, {})};
}

SelfConsistency judged(const std::vector<AsrEvidence>& evidence, const Pose2& second,
                       const std::map<AsrId, RoomId>& rooms = {{1, 1}, {2, 2}}) {
  return self_consistency(evidence, {{1, {}}, {2, second}}, rooms, {});
}

double value_of(const SelfConsistency& result, ConsistencyFigure figure) {
  return result.figures.at(static_cast<std::size_t>(figure)).value;
}

using F = ConsistencyFigure;

TEST(SelfConsistency, OfAPerfectMapIsNone) {
  const SelfConsistency result = judged(two_rooms(), {4.2, 0, 0});
  EXPECT_EQ(value_of(result, F::room_overlap), 0.0);
  EXPECT_EQ(value_of(result, F::negative_walls), 0.0);
  EXPECT_NEAR(value_of(result, F::door_sides), 0.0, 1e-9);
  EXPECT_TRUE(std::isnan(value_of(result, F::doors_again)));    // none was crossed twice
  EXPECT_TRUE(std::isnan(value_of(result, F::corridor_bend)));  // there is no open passage
  EXPECT_NEAR(result.inconsistency, 0.0, 0.01);
}

TEST(SelfConsistency, OfManyPairsOfRoomsIsThatOfOnePair) {
  constexpr Pose2 kSecond = {3.95, 0.3, 0.02};
  for (const PassageKind kind : {PassageKind::doorway, PassageKind::open_passage}) {
    std::vector<AsrEvidence> evidence;
    std::map<AsrId, Pose2> placed;
    for (int pair = 0; pair < 9; ++pair) {
      const AsrId id = 1 + 2 * pair;
      const Pose2 at{30.0 * (pair % 3) - 41.0, 25.0 * (pair / 3) - 7.0, 0.1 * pair};
      for (AsrEvidence& room : two_rooms(kind, id)) evidence.push_back(std::move(room));
      placed[id] = at;
      placed[id + 1] = at * kSecond;
    }
    const SelfConsistency one = judged(two_rooms(kind), kSecond, {});
    const SelfConsistency many = self_consistency(evidence, placed, {}, {});
    for (const F figure : {F::negative_walls, F::door_sides, F::corridor_bend,
                           F::rays_through_walls, F::hits_in_free_space, F::doubled_walls}) {
      const double expected = value_of(one, figure);
      if (std::isnan(expected)) continue;
      EXPECT_NEAR(value_of(many, figure), expected, 1e-6 + 0.02 * expected) << to_string(figure);
    }
  }
}

TEST(SelfConsistency, OverlapIsTheShareOfTheAreaThatTwoRoomsCover) {
  const SelfConsistency result = judged(two_rooms(), {3.5, 0, 0});
  EXPECT_NEAR(value_of(result, F::room_overlap), 1.5 / 22.5, 0.003);
  const SelfConsistency same = judged(two_rooms(), {3.5, 0, 0}, {{1, 1}, {2, 1}});
  EXPECT_EQ(value_of(same, F::room_overlap), 0.0) << "two visits of one room overlap rightly";
}

TEST(SelfConsistency, NegativeWallsAreTheirDepthOverAllWalls) {
  // 30 of each room's 140 samples back onto the other room, 0.3 m deep inside.
  const SelfConsistency result = judged(two_rooms(), {3.7, 0, 0});
  EXPECT_NEAR(value_of(result, F::negative_walls), 0.3 * 30 / 140, 0.01);
  EXPECT_EQ(value_of(judged(two_rooms(), {4.5, 0, 0}), F::negative_walls), 0.0);
}

TEST(SelfConsistency, DoorSidesAreApartAsTheRoomsAre) {
  EXPECT_NEAR(value_of(judged(two_rooms(), {4.2, 0.4, 0}), F::door_sides), 0.4, 1e-9);
  // Turned about the door's middle: each jamb moves along a chord.
  const Pose2 pivot{4.1, 1, 0};
  const Pose2 turned = pivot * Pose2{0, 0, radians(10)} * inverse(pivot) * Pose2{4.2, 0, 0};
  EXPECT_NEAR(value_of(judged(two_rooms(), turned), F::door_sides), 2 * 0.5 * std::sin(radians(5)),
              1e-9);
}

TEST(SelfConsistency, ADoorMetAgainIsAsFarAsItCameToLie) {
  Asr first = seen_room(1);
  first.exits = {exit_at(PassageKind::doorway, false, {4.1, 1, 0}, 7)};
  Asr again = seen_room(2);  // the same room, left by the same door into another ASR
  again.exits = {exit_at(PassageKind::doorway, false, {4.1, 1, 0}, 8)};
  const std::vector<AsrEvidence> evidence = {evidence_of(first, {}), evidence_of(again, {})};
  EXPECT_NEAR(value_of(judged(evidence, {0.3, 0.4, 0}), F::doors_again), 0.5, 1e-9);
  EXPECT_TRUE(std::isnan(value_of(judged(evidence, {1.5, 0, 0}), F::doors_again)));
  EXPECT_TRUE(std::isnan(value_of(judged(evidence, {4, 1, kPi / 2}), F::doors_again)))
      << "a door across leads elsewhere";
}

TEST(SelfConsistency, ACorridorBendsByTheAngleBetweenItsPieces) {
  const auto pieces = two_rooms(PassageKind::open_passage);
  EXPECT_NEAR(value_of(judged(pieces, {4, 0, radians(7)}), F::corridor_bend), 7.0, 1e-6);
  EXPECT_NEAR(value_of(judged(pieces, {4, 0, radians(-88)}), F::corridor_bend), 2.0, 1e-6);
}

TEST(SelfConsistency, TwoVisitsOfOneRoomShowDoubledWalls) {
  const std::map<AsrId, RoomId> one_room{{1, 1}, {2, 1}};
  EXPECT_NEAR(value_of(judged(two_rooms(), {0, 0, 0}, one_room), F::doubled_walls), 0.0, 0.005);
  const SelfConsistency apart = judged(two_rooms(), {0.1, 0, 0}, one_room);
  EXPECT_GT(value_of(apart, F::doubled_walls), 0.02);  // the walls across the shift, by 0.1 m
  EXPECT_LT(value_of(apart, F::doubled_walls), 0.08);
}

TEST(SelfConsistency, HitsInsideAnotherRoomAndRaysThroughItsWallsContradict) {
  const std::map<AsrId, RoomId> one_room{{1, 1}, {2, 1}};
  const SelfConsistency right = judged(two_rooms(), {0, 0, 0}, one_room);
  EXPECT_EQ(value_of(right, F::hits_in_free_space), 0.0);
  EXPECT_EQ(value_of(right, F::rays_through_walls), 0.0);
  const SelfConsistency wrong = judged(two_rooms(), {1, 1, 0}, one_room);
  EXPECT_GT(value_of(wrong, F::hits_in_free_space), 0.3);
  EXPECT_GT(value_of(wrong, F::rays_through_walls), 0.3);
}

TEST(SelfConsistency, OfManyVisitsOfOneRoomFewerRaysSayAsMuch) {
  const AsrEvidence one = evidence_of(seen_room(1), {});
  const auto judged_of = [&](AsrId visits) {  // half of them a metre off
    std::vector<AsrEvidence> all;
    std::map<AsrId, Pose2> placement;
    std::map<AsrId, RoomId> rooms;
    for (AsrId id = 1; id <= visits; ++id) {
      all.push_back(one);
      all.back().asr = id;
      placement[id] = id % 2 == 0 ? Pose2{} : Pose2{1, 1, 0};
      rooms[id] = 1;
    }
    return self_consistency(all, placement, rooms, {});
  };
  const SelfConsistency all_rays = judged_of(64);
  const SelfConsistency fewer = judged_of(160);
  for (const auto figure : {F::hits_in_free_space, F::rays_through_walls, F::doubled_walls}) {
    EXPECT_GT(value_of(all_rays, figure), 0.0);
    EXPECT_NEAR(value_of(fewer, figure), value_of(all_rays, figure),
                0.05 * value_of(all_rays, figure))
        << to_string(figure);
  }
}

TEST(SelfConsistency, DoesNotDependOnWhereTheBuildingLies) {
  const auto evidence = two_rooms();
  const Pose2 second{3.6, 0.3, radians(4)};
  const Pose2 anywhere{-17.3, 40.1, radians(137)};
  const SelfConsistency here = judged(evidence, second);
  const SelfConsistency there =
      self_consistency(evidence, {{1, anywhere}, {2, anywhere * second}}, {{1, 1}, {2, 2}}, {});
  for (std::size_t i = 0; i < here.figures.size(); ++i) {
    if (std::isnan(here.figures[i].value)) continue;
    EXPECT_NEAR(here.figures[i].value, there.figures[i].value, 0.004)
        << to_string(here.figures[i].figure);
  }
}

TEST(SelfConsistency, WithoutReadingsLeavesRaysUnmeasured) {
  Asr first = seen_room(1);
  Asr second = seen_room(2);
  first.readings.clear();
  second.readings.clear();
  const SelfConsistency result =
      judged({evidence_of(first, {}), evidence_of(second, {})}, {3.7, 0, 0});
  EXPECT_TRUE(std::isnan(value_of(result, F::doubled_walls)));
  EXPECT_TRUE(std::isnan(value_of(result, F::rays_through_walls)));
  EXPECT_GT(value_of(result, F::negative_walls), 0.05);
}

TEST(SelfConsistency, ComparesPlacementsAndSaysWhichFiguresAgree) {
  const auto evidence = two_rooms();
  const SelfConsistency good = judged(evidence, {4.2, 0, 0});
  const SelfConsistency bad = judged(evidence, {3.4, 0.5, radians(10)});
  const ConsistencyComparison better = compare(bad, good, {});
  EXPECT_EQ(better.verdict, Verdict::better);
  for (const FigureVote& vote : better.votes) {
    EXPECT_NE(vote.vote, Verdict::worse) << to_string(vote.figure);
    EXPECT_NE(vote.figure, F::door_sides) << "odometry is not to be praised for its doors";
  }
  EXPECT_EQ(compare(good, bad, {}).verdict, Verdict::worse);
  EXPECT_EQ(compare(good, good, {}).verdict, Verdict::undecided);
  EXPECT_EQ(compare(bad, good, {.before_is_odometry = false}).votes.size(),
            better.votes.size() + 1);
}

TEST(SelfConsistency, CallsNoCorrectionWorseThanOdometryForCentimetresAtDoorsAlone) {
  SelfConsistency odometry;
  SelfConsistency corrected;
  odometry.figures = {{F::negative_walls, 0.0, 1.0}, {F::doubled_walls, 0.04, 1.0}};
  corrected.figures = {{F::negative_walls, 0.01, 1.0}, {F::doubled_walls, 0.06, 1.0}};
  EXPECT_EQ(compare(odometry, corrected, {}).verdict, Verdict::undecided);
  EXPECT_EQ(compare(odometry, corrected, {.before_is_odometry = false}).verdict, Verdict::worse);
  EXPECT_EQ(compare(corrected, odometry, {}).verdict, Verdict::better);
  odometry.figures.push_back({F::hits_in_free_space, 0.0, 1.0});
  corrected.figures.push_back({F::hits_in_free_space, 0.1, 1.0});
  EXPECT_EQ(compare(odometry, corrected, {}).verdict, Verdict::worse);
}

TEST(SelfConsistency, OfNothingIsUnmeasured) {
  const SelfConsistency result = self_consistency({}, {}, {}, {});
  EXPECT_EQ(result.figures.size(), static_cast<std::size_t>(kConsistencyFigures));
  EXPECT_EQ(compare(result, result, {}).verdict, Verdict::undecided);
}

}  // namespace
}  // namespace roomatlas
