// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <set>

#include "roomatlas/core/issue.hpp"
#include "roomatlas/simulate/random_building.hpp"
#include "roomatlas/simulate/world.hpp"
#include "support/memory_store.hpp"

namespace roomatlas {
namespace {

using test::MemoryStore;
using testing::Le;

RandomBuildingOptions exact(std::int64_t rooms, std::uint64_t seed = 1) {
  RandomBuildingOptions options;
  options.rooms = rooms;
  options.seed = seed;
  options.odometry = {0.0, 0.0, 0.0, 0.0};
  options.vertex_noise_m = 0.0;
  options.jamb_noise_m = 0.0;
  return options;
}

struct Built {
  MemoryStore store;
  std::map<AsrId, TrueVisit> truth;
  RandomBuildingSummary summary;
};

Built built(const RandomBuildingOptions& options) {
  Built result;
  result.summary = random_building(
      options, result.store, [&](const TrueVisit& visit) { result.truth[visit.asr] = visit; });
  return result;
}

const PlanRoom& room_of(const FloorPlan& plan, RoomId id) {
  return plan.rooms.at(static_cast<std::size_t>(id - 1));
}

/// The plan's door that has its middle within reach of a place; null where there is none.
const PlanDoor* door_at(const FloorPlan& plan, const Point2& place, double reach_m) {
  for (const PlanDoor& door : plan.doors) {
    if (((door.jambs.a + door.jambs.b) / 2.0 - place).norm() <= reach_m) return &door;
  }
  return nullptr;
}

class RandomBuildingOfAnySize : public testing::TestWithParam<std::int64_t> {};

TEST_P(RandomBuildingOfAnySize, HasAsManyRoomsAsAskedForAndEachIsVisited) {
  const Built building = built(exact(GetParam()));
  const FloorPlan plan = random_building_plan(exact(GetParam()));
  ASSERT_EQ(static_cast<std::int64_t>(plan.rooms.size()), GetParam());
  std::set<RoomId> visited;
  for (const auto& [asr, visit] : building.truth) visited.insert(visit.room);
  EXPECT_EQ(static_cast<std::int64_t>(visited.size()), GetParam());
  EXPECT_EQ(*visited.begin(), 1);
  EXPECT_EQ(*visited.rbegin(), GetParam());
}

TEST_P(RandomBuildingOfAnySize, IsASoundWorldInWhichEveryRoomCanBeReached) {
  // overlapping rooms, closed-off rooms and doors without rooms would be issues
  const FloorPlan plan = random_building_plan(exact(GetParam()));
  for (const Issue& issue : check_world(plan)) {
    EXPECT_EQ(issue.severity, Severity::note) << to_string(issue);
  }
}

TEST_P(RandomBuildingOfAnySize, HandsOverAsrsInOrderAndInOneChain) {
  const Built building = built(exact(GetParam()));
  AsrId id = 0;
  for (const Asr& asr : building.store.asrs) {
    ASSERT_EQ(asr.id, ++id);
    ASSERT_FALSE(asr.path.empty());
    const bool is_first = id == 1;
    const bool is_last = id == building.summary.asrs;
    ASSERT_EQ(asr.exits.size(), (is_first ? 0U : 1U) + (is_last ? 0U : 1U));
    if (!is_first) {
      EXPECT_TRUE(asr.exits.front().is_entry);
      EXPECT_EQ(asr.exits.front().neighbor, id - 1);
      EXPECT_EQ(asr.exits.front().frame_from_pivot.position(), Point2(0.0, 0.0));
    }
    if (!is_last) {
      EXPECT_FALSE(asr.exits.back().is_entry);
      EXPECT_EQ(asr.exits.back().neighbor, id + 1);
    }
  }
  EXPECT_EQ(id, building.summary.asrs);
}

TEST_P(RandomBuildingOfAnySize, DrivesThroughEachDoorOfThePlan) {
  const Built building = built(exact(GetParam()));
  const FloorPlan plan = random_building_plan(exact(GetParam()));
  std::set<std::int64_t> crossed;
  for (const Asr& asr : building.store.asrs) {
    for (const Exit& exit : asr.exits) {
      if (exit.kind != PassageKind::doorway) continue;
      const Pose2 world_from_pivot =
          building.truth.at(asr.id).world_from_asr * exit.frame_from_pivot;
      const PlanDoor* door = door_at(plan, world_from_pivot.position(), 1e-6);
      ASSERT_NE(door, nullptr) << "ASR " << asr.id;
      crossed.insert(door->id);
      EXPECT_NEAR(exit.width_m, door->width_m, 1e-9);
      const RoomId here = building.truth.at(asr.id).room;
      const RoomId there = building.truth.at(*exit.neighbor).room;
      EXPECT_EQ(std::minmax(here, there), std::minmax(*door->room_a, *door->room_b));
    }
  }
  EXPECT_EQ(crossed.size(), plan.doors.size());
  EXPECT_EQ(building.summary.doors, static_cast<std::int64_t>(plan.doors.size()));
}

INSTANTIATE_TEST_SUITE_P(RandomBuilding, RandomBuildingOfAnySize,
                         testing::Values(1, 2, 3, 7, 20, 21, 60, 137, 400));

TEST(RandomBuilding, HasAboutOnePointThreeDoorsARoomAndRoomsOfManySizes) {
  const FloorPlan plan = random_building_plan(exact(1000));
  EXPECT_NEAR(static_cast<double>(plan.doors.size()) / 1000.0, 1.3, 0.15);
  int corridors = 0;
  int halls = 0;
  int offices = 0;
  for (const PlanRoom& room : plan.rooms) {
    corridors += room.kind == RoomKind::corridor ? 1 : 0;
    halls += room.kind == RoomKind::hall ? 1 : 0;
    offices += room.kind == RoomKind::room && room.area_m2 < 25.0 ? 1 : 0;
  }
  EXPECT_EQ(corridors, 50);
  EXPECT_GT(halls, 20);
  EXPECT_LT(halls, 150);
  EXPECT_GT(offices, 400);
}

TEST(RandomBuilding, ExitsOfBothSidesAreTheSameDoorwayAtTruePoses) {
  RandomBuildingOptions options = exact(60);
  options.jamb_noise_m = 0.04;
  const Built building = built(options);
  double squares = 0.0;
  int doorways = 0;
  const FloorPlan plan = random_building_plan(options);
  for (const Asr& asr : building.store.asrs) {
    if (asr.exits.empty() || asr.exits.back().is_entry) continue;
    const Exit& out = asr.exits.back();
    const Asr& next = building.store.asrs.at(static_cast<std::size_t>(asr.id));
    const Exit& in = next.exits.front();
    const Pose2 world_from_out = building.truth.at(asr.id).world_from_asr * out.frame_from_pivot;
    const Pose2 world_from_in = building.truth.at(next.id).world_from_asr * in.frame_from_pivot;
    EXPECT_LE((world_from_out.position() - world_from_in.position()).norm(), 1e-6);
    EXPECT_NEAR(std::abs(wrap_angle(world_from_out.theta_rad - world_from_in.theta_rad)), kPi,
                1e-6);
    const Point2 left = building.truth.at(asr.id).world_from_asr * out.jambs.a;
    const Point2 right = building.truth.at(next.id).world_from_asr * in.jambs.b;
    EXPECT_LE((left - right).norm(), 1e-6);
    if (out.kind != PassageKind::doorway) continue;
    const PlanDoor* door = door_at(plan, world_from_out.position(), 0.2);
    ASSERT_NE(door, nullptr);
    const Point2 middle = (door->jambs.a + door->jambs.b) / 2.0;
    squares += (middle - world_from_out.position()).squaredNorm();
    ++doorways;
  }
  // the mid-point of two jambs, each 0.04 m off an axis
  EXPECT_NEAR(std::sqrt(squares / (2.0 * doorways)), 0.04 / std::sqrt(2.0), 0.004);
}

TEST(RandomBuilding, OutlinesLieInTheirTrueRoomsAndReachIntoTheUsedDoorways) {
  const Built building = built(exact(60));
  const FloorPlan plan = random_building_plan(exact(60));
  for (const Asr& asr : building.store.asrs) {
    const TrueVisit& visit = building.truth.at(asr.id);
    const Ring& room = room_of(plan, visit.room).parts.front().outer;
    EXPECT_GT(area(asr.outline_asr), 0.0);
    for (const Point2& vertex : asr.outline_asr.outer) {
      const Point2 at = visit.world_from_asr * vertex;
      EXPECT_TRUE(contains(room, at) || distance_to_boundary(room, at) <= 0.1 + 1e-6)
          << "ASR " << asr.id;
    }
    for (const PathSample& sample : asr.path) {
      EXPECT_TRUE(contains(asr.outline_asr, sample.asr_from_robot.position())) << "ASR " << asr.id;
    }
    for (const WallPolyline& wall : asr.walls) {
      ASSERT_EQ(wall.edge_is_fitted.size() + 1, wall.vertices_asr.size());
      for (const Point2& vertex : wall.vertices_asr) {
        EXPECT_LE(distance_to_boundary(room, visit.world_from_asr * vertex), 1e-6);
      }
    }
  }
}

TEST(RandomBuilding, WallsLeaveTheDoorsOpen) {
  const FloorPlan plan = random_building_plan(exact(137));
  for (const PlanDoor& door : plan.doors) {
    const Point2 middle = (door.jambs.a + door.jambs.b) / 2.0;
    for (const Polygon& wall : plan.walls) {
      EXPECT_FALSE(contains(wall, middle)) << "door " << door.id;
      EXPECT_FALSE(contains(wall, 0.9 * door.jambs.a + 0.1 * middle)) << "door " << door.id;
    }
  }
}

TEST(RandomBuilding, OdometryDriftsByTheGivenErrorsOverThePathDriven) {
  RandomBuildingOptions options = exact(200);
  options.odometry = {0.01, 0.2, 0.0, 0.0};  // no random part: the drift is known
  const Built building = built(options);
  double reported_m = 0.0;
  for (const Asr& asr : building.store.asrs) {
    const TrueVisit& visit = building.truth.at(asr.id);
    const double turned_rad =
        wrap_angle(asr.odom_from_asr.theta_rad - visit.world_from_asr.theta_rad);
    // odometry starts at heading 0, as the true drive does
    const double driven_m = reported_m / 1.01;
    EXPECT_NEAR(wrap_angle(turned_rad - radians(0.2 * driven_m)), 0.0, 1e-6);
    // The way to the next ASR's frame, and not only to the last sample.
    const Point2 to_exit = asr.id < building.summary.asrs
                               ? asr.exits.back().frame_from_pivot.position()
                               : asr.path.back().asr_from_robot.position();
    Point2 last = Point2::Zero();
    for (const PathSample& sample : asr.path) {
      reported_m += (sample.asr_from_robot.position() - last).norm();
      last = sample.asr_from_robot.position();
    }
    reported_m += (to_exit - last).norm();
  }
  EXPECT_NEAR(reported_m, 1.01 * building.summary.path_length_m, 1e-3 * reported_m);
}

TEST(RandomBuilding, VisitsAreCutBeforeTheyAreTooLong) {
  const Built building = built(exact(60));
  int open_passages = 0;
  for (const Asr& asr : building.store.asrs) {
    EXPECT_THAT(path_length_m(asr), Le(8.0 + 1.5)) << "the way into a door is not cut";
    if (!asr.exits.empty() && asr.exits.back().kind == PassageKind::open_passage) ++open_passages;
  }
  EXPECT_GT(open_passages, 20);
}

TEST(RandomBuilding, TheSameSeedGivesTheSameAsrsAndAnotherSeedOthers) {
  RandomBuildingOptions options;
  options.rooms = 45;
  const Built first = built(options);
  const Built again = built(options);
  options.seed = 2;
  const Built other = built(options);
  ASSERT_EQ(first.store.asrs.size(), again.store.asrs.size());
  for (std::size_t i = 0; i < first.store.asrs.size(); ++i) {
    const Asr& a = first.store.asrs[i];
    const Asr& b = again.store.asrs[i];
    EXPECT_EQ(a.odom_from_asr, b.odom_from_asr);
    EXPECT_EQ(a.outline_asr.outer, b.outline_asr.outer);
    ASSERT_EQ(a.walls.size(), b.walls.size());
  }
  EXPECT_NE(first.store.asrs.at(5).odom_from_asr, other.store.asrs.at(5).odom_from_asr);
}

TEST(RandomBuilding, KeepsNothingOfABuildingInMemory) {
  // Blocks can be asked for in any order and the sink is the only place that ASRs go to: what is
  // left to see is that a building of many blocks comes as many small parts.
  RandomBuildingOptions options = exact(20000);
  std::size_t largest = 0;
  std::size_t rooms = 0;
  random_building_plan(options, [&](const FloorPlan& part) {
    largest = std::max(largest, part.rooms.size());
    rooms += part.rooms.size();
  });
  EXPECT_EQ(rooms, 20000U);
  EXPECT_LE(largest, 20U);
}

TEST(RandomBuilding, RefusesABuildingWithoutRoomsAndNoiseThatIsNoLength) {
  MemoryStore store;
  EXPECT_THROW(random_building(exact(0), store), UsageError);
  EXPECT_THROW((void)random_building_plan(exact(-5)), UsageError);
  RandomBuildingOptions options = exact(5);
  options.vertex_noise_m = -1.0;
  EXPECT_THROW(random_building(options, store), UsageError);
  options = exact(5);
  options.sample_every_m = 0.0;
  EXPECT_THROW(random_building(options, store), UsageError);
}

}  // namespace
}  // namespace roomatlas
