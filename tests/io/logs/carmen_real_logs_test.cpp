// SPDX-License-Identifier: GPL-3.0-or-later
// What the recorded logs are known to hold.
#include "io/mission_log.hpp"
#include "support/shared_data.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/trajectories/relations.hpp"

namespace roomatlas {
namespace {

using test::shared_data;

/// Reads a log without keeping its readings.
struct Summary {
  MissionInfo info;
  std::map<std::size_t, int> readings_by_beams;
  Trajectory trajectory;
};

std::optional<Summary> summary_of(const std::string& name) {
  const auto file = shared_data(name);
  if (!file) return std::nullopt;
  Summary summary;
  const auto source = open_mission(*file, {});
  while (const auto event = source->next()) {
    const auto& reading = std::get<RangeReading>(*event);
    ++summary.readings_by_beams[reading.ranges_m.size()];
    EXPECT_EQ(reading.sensor->robot_from_beam.size(), reading.ranges_m.size());
    summary.trajectory.push_back({reading.timestamp_s, reading.odom_from_robot});
  }
  summary.info = source->info();
  EXPECT_EQ(summary.info.malformed_lines, 0) << name;
  EXPECT_TRUE(summary.info.issues.empty()) << name;
  return summary;
}

TEST(RealLog, Freiburg079HasItsScansAndItsLaser4CentimetresBehindTheCentre) {
  const auto log = summary_of("logs/fr079/fr079.clf.gz");
  if (!log) return;
  EXPECT_EQ(log->info.readings, 4934);
  EXPECT_EQ(log->info.line_counts.at("ODOM"), 8951);
  EXPECT_EQ(log->readings_by_beams, (std::map<std::size_t, int>{{360, 4934}}));
  EXPECT_EQ(log->info.odometry, "poses in scans");
  EXPECT_NEAR(log->info.path_length_m, 392.0, 1.0);
  EXPECT_EQ(log->info.footprint.length_m, 0.47);
  EXPECT_EQ(log->info.footprint.width_m, 0.41);
  ASSERT_EQ(log->info.sensors.size(), 1U);
  EXPECT_NEAR(log->info.sensors[0]->robot_from_beam[0].x_m, -0.04, 1e-9);
  EXPECT_NEAR(log->info.sensors[0]->robot_from_beam[0].y_m, 0.0, 1e-9);
  EXPECT_EQ(log->info.sensors[0]->robot_from_beam[0].theta_rad, radians(-90.0));
  EXPECT_NEAR(*log->info.last_timestamp_s - *log->info.first_timestamp_s, 1061.0, 2.0);
}

TEST(RealLog, AcesHasItsScans) {
  const auto log = summary_of("logs/aces/aces.clf.gz");
  if (!log) return;
  EXPECT_EQ(log->info.readings, 7374);
  EXPECT_EQ(log->info.line_counts.at("ODOM"), 7375);
  EXPECT_EQ(log->readings_by_beams, (std::map<std::size_t, int>{{180, 7374}}));
  EXPECT_NEAR(log->info.path_length_m, 325.0, 1.0);
}

TEST(RealLog, KillianCourtHasNoOdometryLinesButPosesInItsScans) {
  const auto log = summary_of("logs/mit-killian/mit-killian.reconstructed.clf.gz");
  if (!log) return;
  EXPECT_EQ(log->info.readings, 17480);
  EXPECT_FALSE(log->info.line_counts.contains("ODOM"));
  EXPECT_EQ(log->info.odometry, "poses in scans");
  EXPECT_NEAR(log->info.path_length_m, 1911.0, 1.0);
  EXPECT_EQ(log->info.sensors.size(), 1U);
}

TEST(RealLog, CsailHasScansOf361Beams) {
  const auto log = summary_of("logs/mit-csail/mit-csail.clf.gz");
  if (!log) return;
  EXPECT_EQ(log->info.readings, 1988);
  EXPECT_EQ(log->readings_by_beams, (std::map<std::size_t, int>{{361, 1988}}));
  EXPECT_NEAR(log->info.path_length_m, 374.0, 1.0);
}

TEST(RealLog, CorrectedLogsAreReadable) {
  const std::map<std::string, int> scans = {
      {"logs/fr079/fr079.gfs-corrected.log.gz", 4791},
      {"logs/aces/aces.gfs-corrected.log.gz", 440},
      {"logs/mit-csail/mit-csail.gfs-corrected.log.gz", 406},
      {"logs/corrected-only/belgioioso.gfs-corrected.log.gz", 395},
      {"logs/corrected-only/orebro.gfs-corrected.log.gz", 237},
      {"logs/corrected-only/uw-seattle.gfs-corrected.log.gz", 241},
      {"logs/corrected-only/mit-infinite-corridor.gfs-corrected.log.gz", 1941},
  };
  for (const auto& [name, count] : scans) {
    const auto log = summary_of(name);
    if (!log) return;
    EXPECT_EQ(log->info.readings, count) << name;
    EXPECT_EQ(log->info.ignored_line_counts.at("NEFF"), count) << name;
    EXPECT_EQ(log->info.sensors.size(), 1U) << name;
  }
}

TEST(RealLog, LogsInOtherFormatsAreRefused) {
  for (const char* name :
       {"logs/sonar-minirobot/testdata-film03.txt.gz", "logs/fr079/fr079.relations",
        "floorplans/carmen/freiburg.map.gz", "rooms/NLB/NLB.png"}) {
    const auto file = shared_data(name);
    if (!file) return;
    EXPECT_THROW((void)open_mission(*file, {}), InputError) << name;
  }
}

TEST(RealLog, EveryRelationOfFreiburg079MeetsAScanByItsTimestamp) {
  const auto log = summary_of("logs/fr079/fr079.clf.gz");
  const auto file = shared_data("logs/fr079/fr079.relations");
  if (!log || !file) return;
  const std::vector<Relation> relations = read_relations(*file);
  EXPECT_EQ(relations.size(), 1685U);
  for (const Relation& relation : relations) {
    for (const double time_s : {relation.t1_s, relation.t2_s}) {
      EXPECT_TRUE(std::any_of(log->trajectory.begin(), log->trajectory.end(),
                              [&](const StampedPose& pose) { return pose.timestamp_s == time_s; }))
          << time_s;
    }
  }
}

}  // namespace
}  // namespace roomatlas
