// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/messages.hpp"
#include "bags/sweep_path.hpp"

#include "roomatlas/mission/mission.hpp"

#include <map>
#include <memory>

namespace roomatlas::io {

/// What of a cloud is taken.
struct CloudSlice {
  double low_m = 0.0;  ///< heights in the robot's frame ...
  double high_m = 0.0;
  bool is_flat = false;      ///< ... of no meaning here: a planar laser's cloud, all points count
  RobotFootprint footprint;  ///< points inside are the robot itself
  double max_range_m = 0.0;
};

/// Makes readings of point clouds: a ring of 720 bearings around the sensor with the nearest point
/// of each. A bearing without points is no reading: a cloud does not say what was not hit.
class CloudRing {
 public:
  static constexpr int kBearings = 720;

  /// Without time and pose.
  /// @param path of the robot from the first point's time to the last one's
  [[nodiscard]] RangeReading read(const CloudMessage& cloud, const Transform3& base_from_cloud,
                                  const CloudSlice& slice, const SweepPath& path);
  [[nodiscard]] std::int64_t clouds() const { return clouds_; }
  /// Clouds of which each point was put to its own pose.
  [[nodiscard]] std::int64_t unrolled() const { return unrolled_; }
  [[nodiscard]] std::int64_t points() const { return points_; }
  [[nodiscard]] std::int64_t points_taken() const { return taken_; }

 private:
  [[nodiscard]] std::shared_ptr<const RangeSensor> ring_at(const Point2& place, double max_range_m);

  std::vector<std::shared_ptr<const RangeSensor>> rings_;  ///< by place, to 1 mm
  std::int64_t clouds_ = 0;
  std::int64_t unrolled_ = 0;
  std::int64_t points_ = 0;
  std::int64_t taken_ = 0;
};

}  // namespace roomatlas::io
