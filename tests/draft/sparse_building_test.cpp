// SPDX-License-Identifier: GPL-3.0-or-later
// A building in a box that is mostly empty is drafted as it is in its own box.
#include <gtest/gtest.h>

#include "known_poses.hpp"
#include "roomatlas/draft/draft_building.hpp"

namespace roomatlas {
namespace {

/// The evidence with one cell that a beam crossed far away: its masks then hold no box.
BuildingEvidence with_a_far_cell(BuildingEvidence evidence) {
  for (ReflectionMap* map : {&evidence.counts, &evidence.coarse}) {
    map->set(map->frame().cell_of({140.0, -160.0}), CellCounts{0, 1});
  }
  return evidence;
}

void expect_the_same_draft(const BuildingEvidence& evidence) {
  const BuildingEvidence sparse = with_a_far_cell(evidence);
  const DraftedBuilding expected = draft_building(evidence, {});
  const DraftedBuilding found = draft_building(sparse, {});
  ASSERT_LT(found.occupancy.free.domain.count(), found.occupancy.free.domain.bounds().count() / 5)
      << "the masks still have all of their box";
  ASSERT_EQ(found.rooms.size(), expected.rooms.size());
  for (std::size_t i = 0; i < found.rooms.size(); ++i) {
    EXPECT_EQ(found.rooms[i].id, expected.rooms[i].id);
    EXPECT_NEAR(area(found.rooms[i].outline), area(expected.rooms[i].outline), 1e-3);
    EXPECT_EQ(found.rooms[i].outline.outer.size(), expected.rooms[i].outline.outer.size());
  }
  ASSERT_EQ(found.doors.size(), expected.doors.size());
  for (std::size_t i = 0; i < found.doors.size(); ++i) {
    EXPECT_LT((found.doors[i].jambs.a - expected.doors[i].jambs.a).norm(), 1e-6);
    EXPECT_LT((found.doors[i].jambs.b - expected.doors[i].jambs.b).norm(), 1e-6);
  }
  EXPECT_EQ(found.furniture.size(), expected.furniture.size());
  EXPECT_EQ(found.partition.room_of_pose, expected.partition.room_of_pose);
  const auto outlines = measured_outlines(expected, evidence, {});
  const auto sparse_outlines = measured_outlines(found, sparse, {});
  ASSERT_EQ(outlines.size(), sparse_outlines.size());
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    EXPECT_NEAR(area(sparse_outlines[i].outline), area(outlines[i].outline), 1e-9);
  }
}

TEST(SparseBuilding, OfALaserIsDraftedAsInItsOwnBox) {
  expect_the_same_draft(test::eight_rooms(SensorKind::laser, {}, 3).evidence);
}

TEST(SparseBuilding, OfSonarsIsDraftedAsInItsOwnBox) {
  expect_the_same_draft(test::eight_rooms(SensorKind::sonar, {}, 4).evidence);
}

}  // namespace
}  // namespace roomatlas
