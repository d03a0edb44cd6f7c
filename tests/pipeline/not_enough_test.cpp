// SPDX-License-Identifier: GPL-3.0-or-later
// What cannot be mapped, and what an interruption leaves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/memory_mission.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/core/progress.hpp"
#include "roomatlas/pipeline/assemble.hpp"
#include "roomatlas/pipeline/map_mission.hpp"

namespace roomatlas {
namespace {

using namespace test;
using testing::HasSubstr;

const WorldDrawing kRoom = {"####################",  //
                            "#                  #",  //
                            "#   b          a   #",  //
                            "#                  #",  //
                            "#                  #",  //
                            "#                  #",  //
                            "#                  #",  //
                            "#   c          d   #",  //
                            "#                  #",  //
                            "####################"};

std::string refusal(MemoryMission mission) {
  MemoryStore store;
  try {
    (void)map_mission(mission, store, {});
  } catch (const NotEnoughError& error) {
    return error.what();
  }
  return "no error";
}

TEST(MapMission, SaysThatThereAreNoRangeReadings) {
  EXPECT_THAT(refusal(MemoryMission({})), HasSubstr("no range readings"));
  EXPECT_THAT(refusal(MemoryMission({TruePose{1.0, {}}, TruePose{2.0, {}}})),
              HasSubstr("no range readings"));
}

TEST(MapMission, SaysThatThereIsNoOdometry) {
  EXPECT_THAT(refusal(MemoryMission(events_of(readings_in(kRoom)), "none")),
              HasSubstr("no odometry"));
}

TEST(MapMission, SaysThatNoWallWasSeen) {
  auto readings = readings_in({"    ", "a  b", "    "});
  EXPECT_THAT(refusal(MemoryMission(events_of(readings))), HasSubstr("no wall was seen"));
  for (RangeReading& reading : readings) {
    std::fill(reading.ranges_m.begin(), reading.ranges_m.end(), 0.0F);
  }
  EXPECT_THAT(refusal(MemoryMission(events_of(readings))), HasSubstr("no wall was seen"));
}

TEST(MapMission, NamesTheFileInEachRefusal) {
  EXPECT_THAT(refusal(MemoryMission({})), HasSubstr("memory.clf: "));
  EXPECT_THAT(refusal(MemoryMission({}, "none")), HasSubstr("memory.clf: "));
}

TEST(MapMission, LeavesWholeAsrsBehindWhenItIsInterrupted) {
  const auto readings = readings_along(surfaces_of(kRoom), {{4.7, 2.2},
                                                            {1.4, 2.2},
                                                            {1.4, 0.8},
                                                            {4.7, 0.8},
                                                            {4.7, 2.2},
                                                            {1.4, 2.2},
                                                            {1.4, 0.8},
                                                            {4.7, 0.8},
                                                            {4.7, 2.2},
                                                            {1.4, 2.2},
                                                            {1.4, 0.8}});
  ASSERT_GT(readings.size(), 520U);
  MemoryMission mission(events_of(readings));
  MemoryStore store;
  int calls = 0;
  const Progress stop_at_the_second = [&](const std::string&, double done) {
    EXPECT_GT(done, 0.0);
    EXPECT_LE(done, 1.0);
    return ++calls < 2;
  };
  EXPECT_THROW((void)map_mission(mission, store, {}, stop_at_the_second), Interrupted);

  // All that was read until then is there, each reading once, and it can be assembled.
  std::size_t next = 0;
  for (const Asr& asr : store.asrs) {
    EXPECT_FALSE(asr.walls.empty());
    EXPECT_EQ(asr.readings.size(), asr.path.size());
    for (const PathSample& sample : asr.path) {
      EXPECT_EQ(sample.timestamp_s, readings[next++].timestamp_s);
    }
  }
  EXPECT_EQ(next, static_cast<std::size_t>(mission.info().readings));
  EXPECT_LT(next, readings.size());
  EXPECT_EQ(assemble(store, {}, {}).plan.rooms.size(), 1U);
}

TEST(MapMission, HandsTheTruthOnInOrder) {
  const auto events = sonar_mission(kRoom);
  const MemoryStore store = mapped(events);
  ASSERT_EQ(store.true_poses.size(), events.size() / 2);
  for (std::size_t i = 0; i < store.true_poses.size(); ++i) {
    const auto& truth = std::get<TruePose>(events[2 * i + 1]);
    EXPECT_EQ(store.true_poses[i].timestamp_s, truth.timestamp_s);
    EXPECT_EQ(store.true_poses[i].world_from_robot, truth.world_from_robot);
  }
}

TEST(Assemble, SaysThatAStoreWithoutAsrsIsNotEnough) {
  EXPECT_THROW((void)assemble(MemoryStore(), {}, {}), NotEnoughError);
}

TEST(Assemble, StopsWhenProgressSaysSo) {
  const MemoryStore store = mapped(events_of(readings_in(kRoom)));
  std::vector<std::string> stages;
  const Progress note = [&](const std::string& stage, double) {
    stages.push_back(stage);
    return true;
  };
  (void)assemble(store, {}, {}, note);
  ASSERT_FALSE(stages.empty());
  for (std::size_t stop_at = 0; stop_at < stages.size(); ++stop_at) {
    std::size_t calls = 0;
    const Progress stop = [&](const std::string&, double) { return calls++ != stop_at; };
    EXPECT_THROW((void)assemble(store, {}, {}, stop), Interrupted) << stages[stop_at];
  }
}

}  // namespace
}  // namespace roomatlas
