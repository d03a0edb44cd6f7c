// SPDX-License-Identifier: GPL-3.0-or-later
// A run that goes on behind each of its checkpoints, against the one that was not disturbed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/memory_mission.hpp"
#include "pipeline/three_rounds.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/core/packed.hpp"
#include "roomatlas/pipeline/map_checkpoint.hpp"
#include "roomatlas/pipeline/map_mission.hpp"

namespace roomatlas {
namespace {

using namespace test;
using testing::HasSubstr;

/// Keeps every checkpoint, and what had been put by then.
struct CheckpointsKept : CheckpointSink {
  void put(const Asr& asr) override { store.put(asr); }
  void put(const TruePose& truth) override { store.put(truth); }
  void put(const Asr& asr, const std::string& checkpoint) override {
    store.put(asr);
    checkpoints.push_back(checkpoint);
    true_poses.push_back(store.true_poses.size());
  }
  MemoryStore store;
  std::vector<std::string> checkpoints;
  std::vector<std::size_t> true_poses;
};

/// All of an ASR that hangs on the readings before it, bit by bit.
std::string bits_of(const Asr& asr) {
  Packer packer;
  packer(asr.id, asr.start_s, asr.end_s, asr.odom_from_asr, asr.reference_point_asr,
         asr.is_localized, asr.counters.vertices, asr.counters.occupied_cells,
         asr.counters.ignored_ranges);
  for (const Exit& exit : asr.exits) {
    packer(exit.frame_from_pivot, exit.width_m, exit.jambs.a, exit.jambs.b, exit.kind,
           exit.is_entry, exit.neighbor, exit.timestamp_s);
  }
  for (const WallPolyline& wall : asr.walls) packer(wall.vertices_asr);
  packer(asr.outline_asr.outer);
  for (const PathSample& sample : asr.path) {
    packer(sample.timestamp_s, sample.asr_from_robot, sample.odom_from_robot);
  }
  for (const RangeReading& reading : asr.readings) packer(reading.timestamp_s, reading.ranges_m);
  return std::move(packer).bytes();
}

CheckpointsKept undisturbed(const std::vector<MissionEvent>& events, MapSummary& summary) {
  CheckpointsKept kept;
  MemoryMission mission(events);
  summary = map_mission(mission, kept, {}, std::nullopt);
  return kept;
}

/// Goes on behind some of the checkpoints and compares all that comes.
void expect_same_behind_checkpoints(const std::vector<MissionEvent>& events, std::size_t every) {
  MapSummary whole;
  const CheckpointsKept first = undisturbed(events, whole);
  ASSERT_GE(first.checkpoints.size(), 10U);
  EXPECT_EQ(first.checkpoints.size() + 1, first.store.asrs.size());
  for (std::size_t i = 0; i < first.checkpoints.size(); i += every) {
    SCOPED_TRACE("checkpoint " + std::to_string(i));
    CheckpointsKept again;
    MemoryMission mission(events);
    const MapCheckpoint from = map_checkpoint_of(first.checkpoints[i]);
    ASSERT_EQ(from.room.asr, static_cast<AsrId>(i) + 2);
    const MapSummary summary = map_mission(mission, again, {}, from);
    EXPECT_EQ(summary.asrs, whole.asrs);
    EXPECT_EQ(summary.wall_vertices, whole.wall_vertices);
    EXPECT_EQ(summary.drives_reversed, whole.drives_reversed);
    EXPECT_EQ(summary.habits, whole.habits);
    ASSERT_EQ(again.store.asrs.size() + i + 1, first.store.asrs.size());
    for (const Asr& asr : again.store.asrs) {
      const Asr& expected = first.store.asrs[static_cast<std::size_t>(asr.id) - 1];
      EXPECT_TRUE(bits_of(asr) == bits_of(expected)) << "ASR " << asr.id;
    }
    const std::vector<std::string> expected(first.checkpoints.begin() + std::ptrdiff_t(i) + 1,
                                            first.checkpoints.end());
    EXPECT_TRUE(again.checkpoints == expected);
    EXPECT_EQ(first.true_poses[i] + again.store.true_poses.size(), first.store.true_poses.size());
  }
}

TEST(MapMissionBehindACheckpoint, IsBitByBitTheSameWithALaser) {
  SimulationOptions laser;
  laser.sensor = SensorKind::laser;
  laser.laser_beams = 61;
  laser.odometry = odometry_errors(OdometryPreset::typical);
  expect_same_behind_checkpoints(three_rounds(laser), 13);
}

TEST(MapMissionBehindACheckpoint, IsTheSameWhereOdometryIsLateAndHasHabits) {
  SimulationOptions late;
  late.sensor = SensorKind::laser;
  late.odometry = odometry_errors(OdometryPreset::hard);
  late.faults.lag_s = 0.3;
  const auto events = three_rounds(late);
  MapSummary whole;
  const CheckpointsKept kept = undisturbed(events, whole);
  ASSERT_TRUE(whole.habits);
  EXPECT_NE(whole.habits->lag_s, 0.0);  // else this tests nothing
  EXPECT_NE(whole.habits->bias_rad_per_m, 0.0);
  const MapCheckpoint last = map_checkpoint_of(kept.checkpoints.back());
  EXPECT_TRUE(last.odometry.is_shifted);
  expect_same_behind_checkpoints(events, 17);
}

TEST(MapMissionBehindACheckpoint, IsTheSameWithSonarsThatDecideDirections) {
  SimulationOptions sonars;
  sonars.rate_hz = 2.0;  // steps are no stops: readings wait for their drive's direction
  expect_same_behind_checkpoints(three_rounds(sonars), 3);
}

TEST(MapMissionBehindACheckpoint, InterruptedPutsNoCheckpointOfItsEnd) {
  SimulationOptions sonars;
  const auto events = three_rounds(sonars);
  MapSummary whole;
  const CheckpointsKept first = undisturbed(events, whole);
  for (const double stop_at : {0.2, 0.5, 0.8}) {
    CheckpointsKept cut;
    MemoryMission mission(events);
    EXPECT_THROW((void)map_mission(mission, cut, {}, std::nullopt,
                                   [&](const std::string&, double done) { return done < stop_at; }),
                 Interrupted);
    ASSERT_LT(cut.checkpoints.size(), cut.store.asrs.size());
    ASSERT_LE(cut.checkpoints.size(), first.checkpoints.size());
    for (std::size_t i = 0; i < cut.checkpoints.size(); ++i) {
      MapCheckpoint its = map_checkpoint_of(cut.checkpoints[i]);
      EXPECT_EQ(its.true_poses, static_cast<std::int64_t>(cut.true_poses[i]));
      its.true_poses =
          static_cast<std::int64_t>(first.true_poses[i]);  // the last room is put early
      EXPECT_EQ(to_bytes(its), first.checkpoints[i]) << i;
    }
  }
}

TEST(MapMissionBehindACheckpoint, InterruptedWhileItReadsWhatWasMappedPutsNothing) {
  const auto events = three_rounds(SimulationOptions{});
  MapSummary whole;
  const CheckpointsKept first = undisturbed(events, whole);
  CheckpointsKept again;
  MemoryMission mission(events);
  EXPECT_THROW((void)map_mission(mission, again, {}, map_checkpoint_of(first.checkpoints.back()),
                                 [](const std::string&, double) { return false; }),
               Interrupted);
  EXPECT_TRUE(again.store.asrs.empty());
}

TEST(MapMissionBehindACheckpoint, OfALongerMissionIsRefused) {
  auto events = three_rounds(SimulationOptions{});
  MapSummary whole;
  const CheckpointsKept first = undisturbed(events, whole);
  events.resize(events.size() / 2);
  CheckpointsKept again;
  MemoryMission mission(events);
  try {
    (void)map_mission(mission, again, {}, map_checkpoint_of(first.checkpoints.back()));
    FAIL() << "it went on";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("had been mapped when the run before was stopped"));
  }
}

TEST(MapCheckpoint, CutShortOrChangedIsRefusedOrInRange) {
  MapSummary whole;
  const CheckpointsKept first = undisturbed(three_rounds(SimulationOptions{}), whole);
  const std::string& bytes = first.checkpoints.front();
  EXPECT_EQ(to_bytes(map_checkpoint_of(bytes)), bytes);
  for (std::size_t length = 0; length < bytes.size(); length += 1 + bytes.size() / 200) {
    EXPECT_THROW((void)map_checkpoint_of(bytes.substr(0, length)), InputError) << length;
  }
  EXPECT_THROW((void)map_checkpoint_of(bytes + '\0'), InputError);
  std::string another_version = bytes;
  another_version[0] = 77;
  try {
    (void)map_checkpoint_of(another_version);
    FAIL() << "it was taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("version 77, expected 1"));
  }
}

}  // namespace
}  // namespace roomatlas
