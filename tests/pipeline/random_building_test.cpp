// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/simulate/random_building.hpp"

#include <gmock/gmock.h>

#include <map>
#include <set>

#include "roomatlas/pipeline/assemble.hpp"
#include "support/memory_store.hpp"

namespace roomatlas {
namespace {

constexpr std::int64_t kRooms = 60;

struct Built {
  test::MemoryStore store;
  std::map<AsrId, TrueVisit> truth;
  FloorPlan plan;
  Assembly assembly;
};

Built assembled(const RandomBuildingOptions& options) {
  Built result;
  random_building(options, result.store,
                  [&](const TrueVisit& visit) { result.truth[visit.asr] = visit; });
  result.plan = random_building_plan(options);
  result.assembly = assemble(result.store, RobotFootprint{}, Options{});
  return result;
}

std::set<RoomId> true_rooms_of(const Built& built, const PlanRoom& room) {
  std::set<RoomId> rooms;
  for (const AsrId asr : room.asrs) rooms.insert(built.truth.at(asr).room);
  return rooms;
}

TEST(AssembleARandomBuilding, WithoutErrorsItGivesTheTrueRoomsAndDoors) {
  RandomBuildingOptions options;
  options.rooms = kRooms;
  options.odometry = {0.0, 0.0, 0.0, 0.0};
  options.vertex_noise_m = 0.0;
  options.jamb_noise_m = 0.0;
  const Built built = assembled(options);
  const FloorPlan& plan = built.assembly.plan;

  ASSERT_EQ(plan.rooms.size(), built.plan.rooms.size());
  std::map<RoomId, RoomId> true_room;  // by the plan's id
  std::set<RoomId> found;
  for (const PlanRoom& room : plan.rooms) {
    const std::set<RoomId> rooms = true_rooms_of(built, room);
    ASSERT_EQ(rooms.size(), 1U) << "room " << room.id << " is made of several";
    true_room[room.id] = *rooms.begin();
    found.insert(*rooms.begin());
    const PlanRoom& truth = built.plan.rooms.at(static_cast<std::size_t>(*rooms.begin() - 1));
    EXPECT_NEAR(room.area_m2, truth.area_m2, 1.5) << "room " << room.id;
  }
  EXPECT_EQ(found.size(), built.plan.rooms.size());

  const auto pairs_of = [](const FloorPlan& of, const auto& name) {
    std::multiset<std::pair<RoomId, RoomId>> pairs;
    for (const PlanDoor& door : of.doors) {
      pairs.insert(std::minmax({name(*door.room_a), name(*door.room_b)}));
    }
    return pairs;
  };
  EXPECT_EQ(pairs_of(plan, [&](RoomId id) { return true_room.at(id); }),
            pairs_of(built.plan, [](RoomId id) { return id; }));
}

TEST(AssembleARandomBuilding, WithMildOdometryTheGraphIsConnectedAndMostDoorsAreRecognised) {
  RandomBuildingOptions options;  // odometry is mild by default
  options.rooms = kRooms;
  const Built built = assembled(options);

  const std::vector<int> components = components_of(built.assembly.graph);
  EXPECT_THAT(components, testing::Each(0));

  // Each crossing of a doorway after its first, by the true doors.
  std::set<std::pair<RoomId, RoomId>> seen;
  int again = 0;
  for (const Asr& asr : built.store.asrs) {
    if (asr.exits.empty() || asr.exits.back().is_entry ||
        asr.exits.back().kind != PassageKind::doorway) {
      continue;
    }
    const auto pair = std::minmax(built.truth.at(asr.id).room, built.truth.at(asr.id + 1).room);
    if (!seen.insert(pair).second) ++again;
  }
  int recognised = 0;
  for (const PassageEdge& edge : built.assembly.graph.edges) {
    if (edge.source == EdgeSource::recognised) ++recognised;
  }
  EXPECT_GE(recognised, again * 8 / 10) << "of " << again;
  EXPECT_NEAR(static_cast<double>(built.assembly.plan.rooms.size()), kRooms, 0.1 * kRooms);
}

}  // namespace
}  // namespace roomatlas
