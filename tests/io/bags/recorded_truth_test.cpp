// SPDX-License-Identifier: GPL-3.0-or-later
// Poses of a recording to compare with, from the file.
#include "bags/bag_writers.hpp"
#include "io/bags/memory_bag.hpp"
#include "support/temporary_folder.hpp"

#include "roomatlas/io/trajectories/trajectory_file.hpp"

#include <gtest/gtest.h>

#include <string>

namespace roomatlas::test {
namespace {

void write(const Path& file, const MemoryBag& bag) {
  const auto writer = io::create_ros1_bag(file, io::Packing::none);
  for (const io::BagTopic& topic : bag.topics) (void)writer->add_topic(topic);
  for (const MemoryBag::Message& message : bag.messages) {
    writer->write(message.topic, message.log_ns, message.bytes);
  }
  writer->finish();
}

Pose2 world_from_base(int i) { return {2.0 + 0.1 * i, 1.0, 0.05 * i}; }

/// A total station that follows a prism, which sits on the robot as tf tells or does not.
MemoryBag with_prism(bool is_joined, const std::string& topic) {
  const Pose2 base_from_prism{0.3, -0.1, kPi / 2};
  MemoryBag bag;
  bag.tf(99.0, {{"base_link", "laser", {}}}, "/tf_static");
  if (is_joined) bag.tf(99.0, {{"base_link", "prism", base_from_prism}}, "/tf_static");
  for (int i = 0; i < 20; ++i) {
    const double time_s = 100.0 + 0.1 * i;
    bag.odometry(time_s, {0.1 * i, 0, 0}).scan(time_s, {});
    MessageBytes out(Layout::ros1);
    const Pose2 seen = world_from_base(i) * base_from_prism;
    out.header(time_s, "map").text("prism").pose(seen.x_m, seen.y_m, 0.4, 0.0, seen.theta_rad);
    bag.add(topic, "geometry_msgs/TransformStamped", time_s, out.bytes);
  }
  return bag;
}

TEST(RecordedTruth, OfAnotherPartOfTheRobotIsJoinedByTf) {
  const TemporaryFolder folder;
  write(folder / "a.bag", with_prism(true, "/total_station"));
  MissionOptions options;
  options.recording.truth_topic = "/total_station";
  const TrajectoryFile truth = read_trajectory(folder / "a.bag", options, LogPoses::truth);
  ASSERT_EQ(truth.poses.size(), 20U);
  for (int i = 0; i < 20; ++i) {
    const Pose2& pose = truth.poses[static_cast<std::size_t>(i)].pose;
    EXPECT_NEAR(pose.x_m, world_from_base(i).x_m, 1e-9);
    EXPECT_NEAR(pose.y_m, world_from_base(i).y_m, 1e-9);
    EXPECT_NEAR(pose.theta_rad, world_from_base(i).theta_rad, 1e-9);
  }
}

TEST(RecordedTruth, ThatNothingJoinsIsAnErrorWithTheRemedy) {
  const TemporaryFolder folder;
  write(folder / "a.bag", with_prism(false, "/total_station"));
  MissionOptions options;
  options.recording.truth_topic = "/total_station";
  try {
    (void)read_trajectory(folder / "a.bag", options, LogPoses::truth);
    FAIL() << "nothing tells where the prism sits";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("--base-frame prism"), std::string::npos)
        << error.what();
  }
  options.recording.base_frame = "prism";
  EXPECT_EQ(read_trajectory(folder / "a.bag", options, LogPoses::truth).poses.size(), 20U);
}

TEST(RecordedTruth, ThatIsFoundByItsNameAndNothingJoinsIsTakenWithAWarning) {
  const TemporaryFolder folder;
  write(folder / "a.bag", with_prism(false, "/ground_truth"));
  const TrajectoryFile truth = read_trajectory(folder / "a.bag", {}, LogPoses::truth);
  EXPECT_EQ(truth.poses.size(), 20U);
  ASSERT_FALSE(truth.issues.empty());
  EXPECT_NE(to_string(truth.issues.back()).find("no tf joins"), std::string::npos);
}

}  // namespace
}  // namespace roomatlas::test
