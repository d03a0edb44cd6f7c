// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/laser_shapes.hpp"
#include "bags/robot_poses.hpp"

#include <map>

namespace roomatlas::io {

/// What was odd about the lasers of a mission.
struct LaserNotes {
  EchoCounts echoes;
  std::int64_t sweeps = 0;
  std::int64_t unrolled = 0;  ///< sweeps of which each beam was put to its own pose
  double most_tilt_rad = 0.0;
  bool is_upside_down = false;
  bool keeps_changing = false;
};

/// How long a sweep takes, from its first beam to its last: by `time_increment`; where that is zero
/// by `scan_time`, which is that of a turn; 0 where neither can be meant.
[[nodiscard]] double sweep_time_s(const LaserScanMessage& scan);

/// Makes readings of laser scans. A reading stands where the robot was at its time, as a rule that
/// of the first beam. Where the robot moved from there, each beam is seen from where it was then,
/// and the sweep is resampled onto the beams of the sensor: the sensors of a mission stay few.
class LaserReader {
 public:
  explicit LaserReader(double trusted_m) : trusted_m_(trusted_m) {}

  /// A sweep, and of which time its reading is.
  struct Sweep {
    std::size_t topic = 0;
    const LaserScanMessage& scan;  ///< without a problem
    std::int64_t stamp_ns = 0;     ///< of its first beam
    std::int64_t reading_ns = 0;   ///< where the robot is put
    Transform3 base_from_laser;
    double order = 1.0;  ///< of its beams in time: 1 as told, -1 reversed, 0 all at once
  };
  [[nodiscard]] RangeReading read(const Sweep& sweep, const RobotPoses& poses, bool has_odometry);
  [[nodiscard]] const LaserNotes& notes() const { return notes_; }

 private:
  void note(const LaserScanMessage& scan, const LaserShape& shape, const RangeLimits& limits);

  double trusted_m_;
  std::map<std::size_t, LaserShapes> shapes_;  ///< by topic
  LaserNotes notes_;
};

}  // namespace roomatlas::io
