// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <vector>

#include "../../src/simulate/steering.hpp"

namespace roomatlas {
namespace {

Pose2 after(const Pose2& pose, const Steering& step) {
  const Pose2 turn{0.0, 0.0, step.turn_rad};
  const Pose2 drive{step.length_m, 0.0, 0.0};
  return step.drives_first ? pose * drive * turn : pose * turn * drive;
}

TEST(Trace, TakesStepsBackThroughThePosesInWhichTheRobotWas) {
  const std::vector<Steering> steps = {
      {0.08, 0.04}, {0.08, 0.0}, {-0.03, 0.013}, {0.0, -0.02}, {0.05, 0.04, true}};
  Trace trace;
  std::vector<Pose2> poses = {{1.0, 2.0, 0.5}};
  for (const Steering& step : steps) {
    trace.add(step);
    poses.push_back(after(poses.back(), step));
  }
  Pose2 pose = poses.back();
  for (std::size_t i = steps.size(); i > 0; --i) {
    const auto back = trace.take_back();
    ASSERT_TRUE(back);
    pose = after(pose, *back);
    EXPECT_NEAR((pose.position() - poses[i - 1].position()).norm(), 0.0, 1e-12);
    EXPECT_NEAR(pose.theta_rad, poses[i - 1].theta_rad, 1e-12);
  }
  EXPECT_FALSE(trace.take_back());
}

TEST(Trace, DoesNotRememberStandingStill) {
  Trace trace;
  trace.add({});
  EXPECT_FALSE(trace.take_back());
}

}  // namespace
}  // namespace roomatlas
