// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/mount_trial.hpp"

#include "roomatlas/match/follow_sweeps.hpp"
#include "roomatlas/match/sensor_mount.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

namespace roomatlas::io {
namespace {

// A motion ends where it is longer than what is off in it, and before sweeps have drifted.
constexpr double kTurnedRad = radians(25.0);
constexpr double kWayM = 0.25;
constexpr double kLongestS = 4.0;

// What a mount must be to be believed.
constexpr double kLeastTurnRad = radians(60.0);  // either way
constexpr double kLeastWayM = 1.5;
constexpr double kMostSigmaM = 0.02;
constexpr double kMostSigmaRad = radians(1.5);
constexpr double kMostOffM = 0.05;
constexpr double kMostOffRad = radians(5.0);
constexpr double kMostScale = 0.1;  // of lengths, more or less than one

class Motions {
 public:
  bool take(const FollowedSweep& sweep) {
    if (!sweep.goes_on || !from_) {
      from_ = sweep;
      return true;
    }
    const SeenMotion motion{inverse(from_->odom_from_robot) * sweep.odom_from_robot,
                            inverse(from_->matched_from_robot) * sweep.matched_from_robot};
    const bool is_long = std::abs(motion.of_robot.theta_rad) > kTurnedRad ||
                         motion.of_robot.position().norm() > kWayM;
    const bool is_late = sweep.timestamp_s - from_->timestamp_s > kLongestS;
    if (is_long && !is_late) motions_.push_back(motion);
    if (is_long || is_late) from_ = sweep;
    return true;
  }
  [[nodiscard]] const std::vector<SeenMotion>& all() const { return motions_; }

 private:
  std::optional<FollowedSweep> from_;
  std::vector<SeenMotion> motions_;
};

bool is_sure(const SensorMount& mount) {
  return std::min(mount.left_rad, mount.right_rad) > kLeastTurnRad && mount.way_m > kLeastWayM &&
         mount.position_sigma_m < kMostSigmaM && mount.heading_sigma_rad < kMostSigmaRad &&
         mount.off_m < kMostOffM && mount.off_rad < kMostOffRad &&
         std::abs(mount.length_scale - 1.0) < kMostScale &&
         mount.robot_from_sensor.position().norm() < 1.0;
}

std::string as_option(const Pose2& mount) {
  std::array<char, 80> text{};
  (void)std::snprintf(text.data(), text.size(), "%.3f,%.3f,%.1f", mount.x_m, mount.y_m,
                      degrees(mount.theta_rad));
  return text.data();
}

std::string in_short(const char* format, double value) {
  std::array<char, 40> text{};
  (void)std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

}  // namespace

void find_mount(TopicChoice& choice, const Survey& beginning, const OpenRecording& open,
                const MissionOptions& options, const std::string& file) {
  if (!options.recording.laser_mount.empty() || choice.scans.size() != 1) return;
  if (choice.odometry == TopicChoice::Odometry::none) return;
  const TopicEvidence& laser = beginning.evidence[choice.scans.front()];
  if (laser.frames.size() != 1 || laser.kind == MessageKind::cloud) return;
  if (RobotPoses(choice, beginning.frames, {}).base_from_frame(laser.frames.front(), 0)) return;
  if (beginning.frames.are_joined(choice.base_frame, laser.frames.front())) return;
  MissionOptions at_the_centre = options;
  at_the_centre.recording.laser_mount = "0,0,0";
  Motions motions;
  try {
    BagSource mission(file, open(), at_the_centre, choice, beginning);
    follow_sweeps(mission, {}, [&](const FollowedSweep& sweep) { return motions.take(sweep); });
  } catch (const std::runtime_error&) {  // who maps it will say it
  }
  const auto mount = mount_from_motions(motions.all());
  if (!mount || !is_sure(*mount)) return;
  choice.mount = mount->robot_from_sensor;
  choice.said += ", laser at " + as_option(*choice.mount) + " (found by its sweeps)";
  choice.issues.push_back(
      {Severity::warning, "", 0, "mount",
       "no tf tells where the laser sits on the robot: found by how its sweeps and odometry move "
       "against each other: --laser-mount " +
           as_option(*choice.mount) + " (surely to " +
           in_short("%.3f m and ", mount->position_sigma_m) +
           in_short("%.1f degrees; motions are off by ", degrees(mount->heading_sigma_rad)) +
           in_short("%.3f", mount->off_m) +
           " m). Give it with that option where it is known better"});
}

}  // namespace roomatlas::io
