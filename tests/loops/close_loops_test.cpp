// SPDX-License-Identifier: GPL-3.0-or-later
// Rooms found again by their walls, on missions whose truth is known.
#include "roomatlas/loops/close_loops.hpp"
#include "roomatlas/correct/place.hpp"
#include "roomatlas/pipeline/assemble.hpp"

#include <gtest/gtest.h>

#include "pipeline/three_rounds.hpp"

namespace roomatlas {
namespace {

using namespace test;

struct Closed {
  MemoryStore store;
  Assembly assembly;
  PlacedMission placed;
};

/// Matches alone: no map that is doubtful is corrected as a whole.
Options matches_alone() {
  Options options;
  options.assemble.correct_sonars = false;
  return options;
}

Closed closed(const std::vector<MissionEvent>& events) {
  Closed result{mapped(events), {}, {}};
  result.assembly = assemble(result.store, {}, matches_alone());
  result.placed = place(result.store, result.assembly.correction);
  return result;
}

/// Mapped and assembled once for all tests.
const Closed& typical() {
  static const Closed result = closed(three_rounds(OdometryPreset::typical));
  return result;
}

TEST(CloseLoops, BringsADriftedMissionToWithinCentimetres) {
  const Closed& mission = typical();
  for (const Asr& asr : mission.store.asrs) EXPECT_TRUE(asr.is_localized) << asr.id;
  const double odometry_m = rmse_m(mission.store, mission.placed.odometry);
  const double corrected_m = rmse_m(mission.store, mission.placed.corrected);
  EXPECT_GT(odometry_m, 1.0);
  EXPECT_LT(corrected_m, 0.15);
  EXPECT_TRUE(mission.assembly.correction.converged) << mission.assembly.correction.message;
}

TEST(CloseLoops, AcceptsClosuresThatAreTrue) {
  const Closed& mission = typical();
  std::map<AsrId, Pose2> world_from_asr;  // in the mean over the path
  std::map<double, Pose2> truth;
  for (const TruePose& pose : mission.store.true_poses) {
    truth[pose.timestamp_s] = pose.world_from_robot;
  }
  for (const Asr& asr : mission.store.asrs) {
    const PathSample& middle = asr.path[asr.path.size() / 2];
    world_from_asr[asr.id] = truth.at(middle.timestamp_s) * inverse(middle.asr_from_robot);
  }
  int accepted = 0;
  int wrong = 0;
  for (const Closure& closure : mission.assembly.closures) {
    EXPECT_LT(closure.from, closure.to);
    if (closure.verdict != ClosureVerdict::accepted) continue;
    ++accepted;
    const Pose2 off = inverse(closure.match.first_from_second) *
                      inverse(world_from_asr.at(closure.from)) * world_from_asr.at(closure.to);
    if (off.position().norm() > 0.3 || std::abs(degrees(off.theta_rad)) > 3.0) ++wrong;
  }
  EXPECT_GE(accepted, static_cast<int>(mission.store.asrs.size()));
  EXPECT_LE(wrong, accepted / 20);  // robust losses hold against a few
}

TEST(CloseLoops, EachAcceptedClosureIsAnEdgeOfTheGraphAndAFactor) {
  const Assembly& assembly = typical().assembly;
  std::map<std::pair<AsrId, AsrId>, const PassageEdge*> matched;
  const std::vector<PassageEdge> edges = assembly.graph.edges;
  for (const PassageEdge& edge : edges) {
    if (edge.source == EdgeSource::matched) matched[{edge.from, edge.to}] = &edge;
  }
  std::size_t accepted = 0;
  for (const Closure& closure : assembly.closures) {
    if (closure.verdict != ClosureVerdict::accepted) continue;
    ++accepted;
    const auto edge = matched.find({closure.from, closure.to});
    ASSERT_NE(edge, matched.end());
    EXPECT_EQ(edge->second->from_from_to, closure.match.first_from_second);
    EXPECT_EQ(edge->second->information, closure.match.information);
  }
  EXPECT_EQ(matched.size(), accepted);
  std::size_t factors = 0;
  for (const FactorReport& factor : assembly.correction.factors) {
    if (factor.kind != FactorKind::closure) continue;
    ++factors;
    EXPECT_EQ(matched.count({factor.from, factor.to}), 1U);
  }
  EXPECT_EQ(factors, accepted);
}

TEST(CloseLoops, GivesTheSameBitsTwice) {
  const Closed& mission = typical();
  const Assembly again = assemble(mission.store, {}, matches_alone());
  ASSERT_EQ(again.closures.size(), mission.assembly.closures.size());
  for (std::size_t i = 0; i < again.closures.size(); ++i) {
    const Closure& a = again.closures[i];
    const Closure& b = mission.assembly.closures[i];
    EXPECT_EQ(a.match.first_from_second, b.match.first_from_second);
    EXPECT_EQ(a.match.information, b.match.information);
    EXPECT_EQ(a.verdict, b.verdict);
  }
  EXPECT_EQ(placement_of(again.correction), placement_of(mission.assembly.correction));
}

TEST(CloseLoops, WithoutMatchingDoorwaysStillBringItNearer) {
  Options options;
  options.assemble.match_rooms = false;
  const MemoryStore& store = typical().store;
  const Assembly assembly = assemble(store, {}, options);
  EXPECT_TRUE(assembly.closures.empty());
  for (const PassageEdge& edge : assembly.graph.edges) {
    EXPECT_NE(edge.source, EdgeSource::matched);
  }
  const PlacedMission placed = place(store, assembly.correction);
  const double doorways_m = rmse_m(store, placed.corrected);
  EXPECT_LT(doorways_m, 0.7 * rmse_m(store, placed.odometry));
  EXPECT_GT(doorways_m, rmse_m(store, typical().placed.corrected));
}

TEST(CloseLoops, HardOdometryEndsNearTheTruthToo) {
  const Closed mission = closed(three_rounds(OdometryPreset::hard));
  EXPECT_GT(rmse_m(mission.store, mission.placed.odometry), 3.0);
  EXPECT_LT(rmse_m(mission.store, mission.placed.corrected), 0.15);
}

/// Half-way through the mission the robot believes to leave a room turned and beside where it does.
MemoryStore lost_half_way() {
  MemoryStore store = typical().store;
  Asr& asr = store.asrs[store.asrs.size() / 2];
  for (Exit& exit : asr.exits) {
    if (!exit.is_entry)
      exit.frame_from_pivot = exit.frame_from_pivot * Pose2{0.0, 1.5, radians(9.0)};
  }
  return store;
}

TEST(CloseLoops, MendsAMissionInWhichTheRobotWasLostOnce) {
  const MemoryStore store = lost_half_way();
  const auto corrected_m = [&](const Options& options) {
    return rmse_m(store, place(store, assemble(store, {}, options).correction).corrected);
  };
  Options as_if_never_lost = matches_alone();
  as_if_never_lost.assemble.closures.max_mends = 0;
  as_if_never_lost.assemble.correct.passage_robust_sigmas = 1e6;
  EXPECT_GT(corrected_m(as_if_never_lost), 0.4);
  EXPECT_LT(corrected_m(matches_alone()), 0.15);
  const Issues issues = assemble(store, {}, matches_alone()).plan.issues;
  EXPECT_EQ(std::count_if(issues.begin(), issues.end(),
                          [](const Issue& issue) { return issue.field == "closures"; }),
            1);
}

TEST(CloseLoops, FewOfManyVisitsToAPlaceSuffice) {
  Options few = matches_alone();
  few.assemble.closures.again_max_candidates = 3;
  const MemoryStore& store = typical().store;
  const Assembly assembly = assemble(store, {}, few);
  EXPECT_LT(assembly.closures.size(), typical().assembly.closures.size() / 2);
  std::map<AsrId, int> earlier;
  for (const Closure& closure : assembly.closures) EXPECT_LE(++earlier[closure.to], 3);
  EXPECT_LT(rmse_m(store, place(store, assembly.correction).corrected), 0.15);
}

TEST(CloseLoops, PartsThatNothingConnectsAreNotMatchedWithEachOther) {
  std::vector<Asr> asrs;
  std::vector<AsrShape> shapes;
  for (const Asr& asr : typical().store.asrs) {
    if (asrs.size() == 4) break;
    asrs.push_back(asr);
    shapes.push_back(shape_of(asr, {}, {}));
    asrs.back().exits.clear();
  }
  const ClosedLoops loops = close_loops({asrs, shapes, build_graph(asrs)}, {}, {});
  EXPECT_TRUE(loops.closures.empty());
  ASSERT_EQ(loops.placement.size(), asrs.size());
  for (const Asr& asr : asrs) EXPECT_EQ(loops.placement.at(asr.id), asr.odom_from_asr);
}

TEST(CloseLoops, OfNothingIsNothing) {
  const ClosedLoops loops = close_loops({{}, {}, build_graph({})}, {}, {});
  EXPECT_TRUE(loops.closures.empty());
  EXPECT_TRUE(loops.placement.empty());
}

}  // namespace
}  // namespace roomatlas
