// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/trajectories/relations.hpp"
#include "roomatlas/io/trajectories/trajectory_file.hpp"

#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomatlas {
namespace {

using ::testing::HasSubstr;

TrajectoryFile read_path(const std::string& text, LogPoses log_poses = LogPoses::recorded) {
  const test::TemporaryFolder folder;
  return read_trajectory(folder.write("file", text), {}, log_poses);
}

std::string refusal(const std::string& text) {
  try {
    (void)read_path(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(TrajectoryFile, IsToldByTheNumberOfItsColumns) {
  EXPECT_EQ(read_path("# a comment\n5 1 2 0 0 0 0 1\n").format, "TUM");
  const TrajectoryFile stamped =
      read_path("# timestamp x y theta\n5.5 1 2 0.5\n6.5 2 2 0.6 # end\n");
  EXPECT_EQ(stamped.format, "poses");
  ASSERT_EQ(stamped.poses.size(), 2U);
  EXPECT_EQ(stamped.poses[0].timestamp_s, 5.5);
  EXPECT_EQ(stamped.poses[0].pose, (Pose2{1, 2, 0.5}));
  const TrajectoryFile plain = read_path("1 2 0.5\n2 2 0.6\n");
  EXPECT_EQ(plain.clock, PoseClock::numbers);
  EXPECT_EQ(plain.poses[1].timestamp_s, 1.0);
}

TEST(TrajectoryFile, OfAGraphHasItsVerticesWithTheirIdsAsTimes) {
  const TrajectoryFile graph =
      read_path("EDGE_SE2 7 3 1 0 0 1 0 0 1 0 1\nVERTEX_SE2 7 1 2 0.5\nVERTEX_SE2 3 0 0 0\n");
  EXPECT_EQ(graph.format, "g2o");
  EXPECT_EQ(graph.clock, PoseClock::numbers);
  ASSERT_EQ(graph.poses.size(), 2U);
  EXPECT_EQ(graph.poses[0].timestamp_s, 7.0);
  EXPECT_EQ(graph.poses[1].timestamp_s, 3.0);
}

TEST(TrajectoryFile, OfAGraphWithScansHasTheirTimestamps) {
  const std::string scan = "ROBOTLASER1 0 -1 2 1 50 0.1 0 1 3.5 0 0 0 0 0 0 0 0 0 0 0 0 ";
  const TrajectoryFile graph =
      read_path("VERTEX2 0 1 2 0.5\n" + scan + "44.25 host 3.5\nVERTEX2 1 2 2 0.5\n" + scan +
                "44.5 host 3.75\n");
  EXPECT_EQ(graph.clock, PoseClock::timestamps);
  EXPECT_EQ(graph.poses[1].timestamp_s, 44.5);
}

TEST(TrajectoryFile, WithoutVerticesSaysSo) {
  EXPECT_THAT(refusal("EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n"), HasSubstr("has no vertices"));
}

TEST(TrajectoryFile, OfALogHasOdometryOrWhereTruthIsMeantItsTruePoses) {
  const std::string log =
      "FLASER 1 3.5 9 2 0 1 2 0.5 100.5 host 0.5\n"
      "TRUEPOS 7 8 0.1 1 2 0.5 100.5 host 0.5\n";
  const TrajectoryFile recorded = read_path(log);
  ASSERT_EQ(recorded.poses.size(), 1U);
  EXPECT_EQ(recorded.poses[0].pose, (Pose2{1, 2, 0.5}));
  EXPECT_EQ(read_path(log, LogPoses::truth).poses.at(0).pose, (Pose2{7, 8, 0.1}));
}

TEST(TrajectoryFile, WithHeadingsInDegreesIsRefused) {
  std::string degrees;
  std::string counted_on;
  for (int i = 0; i < 40; ++i) {
    degrees += std::to_string(i) + " 0 0 " + std::to_string((i * 25) % 360) + "\n";
    counted_on += std::to_string(i) + " 0 0 " + std::to_string(0.4 * i) + "\n";
  }
  EXPECT_THAT(refusal(degrees), HasSubstr("look like degrees"));
  EXPECT_EQ(refusal(counted_on), "");
}

TEST(TrajectoryFile, WithNaNNamesLineAndColumn) {
  EXPECT_THAT(refusal("1 0 0 0\n2 0 nan 0\n"), HasSubstr("file:2: y: expected a finite number"));
}

TEST(Relations, WithYawInDegreesAreRefused) {
  const test::TemporaryFolder folder;
  const Path file = folder.write("x.relations", "1 2 0.5 0 0 0 0 0.1\n2 3 0.5 0 0 0 0 45\n");
  try {
    (void)read_relations(file);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("x.relations:2: yaw: 45"));
    EXPECT_THAT(error.what(), HasSubstr("degrees"));
  }
}

TEST(Clock, IsReadFromLaserLinesThatHaveBothTimes) {
  const test::TemporaryFolder folder;
  const auto clock = read_clock(folder.write("a.clf",
                                             "ODOM 0 0 0 0 0 0 1.5 host 0.1\n"
                                             "FLASER 1 3 0 0 0 0 0 0 2.5 host 0.2\n"
                                             "FLASER 1 3 0 0 0 0 0 0 2.7\n"
                                             "FLASER 1 3 0 0 0 0 0 0 2.9 host 0.6\n"));
  ASSERT_EQ(clock.size(), 2U);
  EXPECT_EQ(clock[1].timestamp_s, 2.9);
  EXPECT_EQ(clock[1].logger_s, 0.6);
  EXPECT_THROW((void)read_clock(folder.write("b.clf", "ODOM 0 0 0 0 0 0 1.5 host 0.1\n")),
               InputError);
}

}  // namespace
}  // namespace roomatlas
