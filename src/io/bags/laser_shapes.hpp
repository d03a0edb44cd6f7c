// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/messages.hpp"
#include "bags/sweep.hpp"

#include "roomatlas/mission/mission.hpp"

#include <memory>
#include <string>
#include <vector>

namespace roomatlas::io {

/// A laser as a scan describes it, where it sits on the robot, and the sensor that this makes.
struct LaserShape {
  std::size_t beams = 0;
  double angle_min_rad = 0.0;
  double angle_increment_rad = 0.0;
  double range_max_m = 0.0;
  Transform3 base_from_laser;

  std::shared_ptr<const RangeSensor> sensor;  ///< beams counter-clockwise as seen from above
  bool is_reversed = false;                   ///< the scan's last beam is the sensor's first
  std::vector<double> level_share;            ///< of each of the scan's ranges, that is horizontal
  double tilt_rad = 0.0;                      ///< of the plane of its beams, [0, pi/2]
  bool is_upside_down = false;

  /// In the robot's plane, where the scan's beam points. Unit.
  [[nodiscard]] Point2 direction_of(std::size_t scan_beam) const;
  [[nodiscard]] std::size_t sensor_beam(std::size_t scan_beam) const {
    return is_reversed ? beams - 1 - scan_beam : scan_beam;
  }
};

/// What is wrong with a scan's numbers, so that it is no sweep of a laser; empty for nothing.
[[nodiscard]] std::string problem_of(const LaserScanMessage& scan);

/// The shapes of one topic's laser, each once: the store keeps every sensor's beams.
class LaserShapes {
 public:
  static constexpr std::size_t kMost = 8;  ///< of one topic; further ones are measured as the first

  struct Found {
    const LaserShape* shape = nullptr;  ///< as the scan is; valid until the next call
    /// The sensor that the reading is to have: the shape's own, or, of a laser whose shape keeps
    /// changing, its first, onto which the sweep has to be resampled.
    std::shared_ptr<const RangeSensor> sensor;
    bool is_new = false;
  };
  /// @param scan without a problem
  [[nodiscard]] Found find(const LaserScanMessage& scan, const Transform3& base_from_laser,
                           double trusted_m);
  [[nodiscard]] bool keeps_changing() const { return shapes_.size() >= kMost; }

 private:
  std::vector<LaserShape> shapes_;
  LaserShape passing_;
};

}  // namespace roomatlas::io
