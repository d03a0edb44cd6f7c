// SPDX-License-Identifier: GPL-3.0-or-later
// Missions of drawn rooms one after the other: what of the earlier ones still counts.
#include "roomatlas/changes/latest_state.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "roomatlas/asr/joined_source.hpp"
#include "roomatlas/draft/occupancy.hpp"
#include "two_rooms.hpp"

namespace roomatlas {
namespace {

const std::vector<Polyline> kWholePath = {test::kFirstRoom, test::kSecondRoom};
const std::vector<Polyline> kThroughTheDoor = {
    {{0.9, 0.9}, {4.2, 0.9}, {3.6, 1.95}, {6.3, 1.95}, {9.3, 3.3}}};
const Point2 kInDoor(4.95, 1.95);

test::WorldDrawing shut_rooms() { return test::with_block(test::empty_rooms(), 16, 5, 1, 3); }
test::WorldDrawing with_table() { return test::with_block(test::empty_rooms(), 7, 6, 3, 2); }
const Polygon kMovedTable = test::block(7, 6, 3, 2);

/// Missions in one store, and the state as each of them leaves it.
class Later {
 public:
  /// @returns what changed
  std::vector<Change> drive(const test::WorldDrawing& rooms, const std::vector<Polyline>& paths) {
    std::vector<AsrId> before = all_.store.ids();
    test::drive(all_, rooms, paths);
    std::vector<AsrId> visits = all_.store.ids();
    visits.erase(visits.begin(), visits.begin() + std::ssize(before));
    const SelectedAsrs now(all_.store, visits);
    const BuildingEvidence later = gathered(now);
    if (before.empty()) {
      state_.evidence = later;
      for (const AsrId visit : visits) state_.times.of_visit[visit] = 0;
      return {};
    }
    const SelectedAsrs then(all_.store, before);
    const FloorPlan plan = test::plan_of_rooms();
    const AssembledMission old_state{&then, all_.mission.placement, plan,
                                     {},    &state_.evidence,       &state_.times};
    const AssembledMission new_state{&now, all_.mission.placement, plan, {}, &later};
    const std::vector<Change> changes = find_changes(old_state, new_state, {}).changes;
    take_in(later, changes, {}, state_);
    return changes;
  }

  [[nodiscard]] BuildingEvidence gathered(const AsrSource& source) const {
    return gather_evidence(source, all_.mission.placement, {}, {}, {});
  }
  [[nodiscard]] BuildingEvidence of_all() const { return gathered(all_.store); }
  [[nodiscard]] BuildingEvidence drafted() const { return as_drafted(of_all(), state_, {}); }
  [[nodiscard]] const LatestState& state() const { return state_; }

 private:
  test::KnownMission all_;
  LatestState state_;
};

/// Cells in which two maps differ, as far from a place as `at_least_m` and farther.
int different(const ReflectionMap& a, const ReflectionMap& b, const Polygon& place,
              double at_least_m) {
  int count = 0;
  for_each_cell(a.box(), [&](const Cell& cell) {
    const Point2 at = a.frame().center_of(cell);
    if (contains(place, at) || distance_to_boundary(place.outer, at) < at_least_m) return;
    if (a.at(cell).hits != b.at(cell).hits || a.at(cell).passes != b.at(cell).passes) ++count;
  });
  return count;
}

/// How many cells of the door are obstacles by the counts (`OccupancyOptions`).
int obstacles_in_door(const ReflectionMap& counts) {
  const OccupancyOptions options;
  int obstacles = 0;
  const CellBox door{counts.frame().cell_of({4.75, 1.6}), counts.frame().cell_of({5.15, 2.3})};
  for_each_cell(door, [&](const Cell& cell) {
    const CellCounts seen = counts.at(cell);
    if (seen.hits >= options.min_hits && seen.reflected_share() >= options.occupied_share) {
      ++obstacles;
    }
  });
  return obstacles;
}

TEST(LatestState, WithoutChangesIsTheSumOfAll) {
  Later missions;
  missions.drive(with_table(), kWholePath);
  EXPECT_TRUE(missions.drive(with_table(), {test::kSecondRoom}).empty());
  const BuildingEvidence drafted = missions.drafted();
  const BuildingEvidence sum = missions.of_all();
  EXPECT_EQ(different(drafted.counts, sum.counts, {}, 0.0), 0);
  EXPECT_EQ(drafted.asr_of_pose, sum.asr_of_pose);
  EXPECT_TRUE(missions.state().shut.empty());
}

TEST(LatestState, OfATableThatIsGoneNothingIsLeftAndAllElseCounts) {
  Later missions;
  missions.drive(with_table(), kWholePath);
  ASSERT_EQ(missions.drive(test::empty_rooms(), kWholePath).size(), 1U);
  const BuildingEvidence drafted = missions.drafted();
  const BuildingEvidence sum = missions.of_all();
  for_each_cell(sum.counts.box(), [&](const Cell& cell) {
    if (contains(kMovedTable, sum.counts.frame().center_of(cell))) {
      EXPECT_EQ(drafted.counts.at(cell).hits, 0);
    }
  });
  const auto on_table = [](const SurfacePoint& surface) {
    return contains(kMovedTable, surface.at) ||
           distance_to_boundary(kMovedTable.outer, surface.at) < 0.05;
  };
  EXPECT_GT(std::count_if(sum.surfaces.begin(), sum.surfaces.end(), on_table), 50);
  EXPECT_EQ(std::count_if(drafted.surfaces.begin(), drafted.surfaces.end(), on_table), 0);
  EXPECT_EQ(different(drafted.counts, sum.counts, kMovedTable, 0.25), 0);
}

TEST(LatestState, WhereATableStandsNowNobodyHasDriven) {
  Later missions;
  missions.drive(test::empty_rooms(), {{{0.9, 2.1}, {4.2, 2.1}}});  // through where it will be
  ASSERT_FALSE(missions.drive(with_table(), kWholePath).empty());
  const BuildingEvidence drafted = missions.drafted();
  const auto in_table = [](const Pose2& pose) { return contains(kMovedTable, pose.position()); };
  const auto& before = missions.state().evidence.building_from_robot;
  EXPECT_GT(std::count_if(before.begin(), before.end(), in_table), 5);
  EXPECT_EQ(std::count_if(drafted.building_from_robot.begin(), drafted.building_from_robot.end(),
                          in_table),
            0);
  ASSERT_EQ(drafted.asr_of_pose.size(), drafted.building_from_robot.size());
  EXPECT_EQ(different(drafted.counts, missions.of_all().counts, kMovedTable, 0.25), 0);
}

TEST(LatestState, ADoorThatWasShutIsAGapAndKnownToBeShut) {
  Later missions;
  missions.drive(test::empty_rooms(), kThroughTheDoor);
  const std::vector<Change> changes = missions.drive(shut_rooms(), {test::kFirstRoom});
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].kind, ChangeKind::door_shut);
  ASSERT_EQ(missions.state().shut.size(), 1U);
  const Segment2 line = missions.state().shut[0].line;
  EXPECT_LT(((line.a + line.b) / 2.0 - kInDoor).norm(), 0.05);
  EXPECT_NEAR((line.b - line.a).norm(), 0.9, 0.05);
  EXPECT_GT(obstacles_in_door(missions.state().evidence.counts), 10);  // as it was seen last
  const BuildingEvidence drafted = missions.drafted();
  EXPECT_EQ(obstacles_in_door(drafted.counts), 0);
  const auto in_door = [](const Pose2& pose) {
    return (pose.position() - kInDoor).cwiseAbs().maxCoeff() < 0.3;
  };
  EXPECT_GT(std::count_if(drafted.building_from_robot.begin(), drafted.building_from_robot.end(),
                          in_door),
            3);
}

TEST(LatestState, ADoorThatIsShutAndOpenedAgainIsToldTwiceAndIsOpen) {
  Later missions;
  missions.drive(test::empty_rooms(), kThroughTheDoor);
  missions.drive(test::empty_rooms(), kWholePath);  // many more saw it open than shut
  const std::vector<Change> shut = missions.drive(shut_rooms(), {test::kFirstRoom});
  ASSERT_EQ(shut.size(), 1U);
  EXPECT_TRUE(missions.drive(shut_rooms(), {test::kFirstRoom}).empty());  // it still is
  EXPECT_EQ(missions.state().shut.size(), 1U);
  const std::vector<Change> opened = missions.drive(test::empty_rooms(), kWholePath);
  ASSERT_EQ(opened.size(), 1U);
  EXPECT_EQ(opened[0].kind, ChangeKind::door_opened);
  EXPECT_TRUE(missions.state().shut.empty());
  EXPECT_EQ(obstacles_in_door(missions.drafted().counts), 0);
}

}  // namespace
}  // namespace roomatlas
