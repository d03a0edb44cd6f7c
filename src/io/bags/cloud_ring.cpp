// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/cloud_ring.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace roomatlas::io {
namespace {

constexpr double kLeastRangeM = 0.05;  // nearer: the sensor's own housing
constexpr double kSamePlaceM = 1e-3;
constexpr double kStepRad = 2.0 * kPi / CloudRing::kBearings;

bool is_of_the_robot(const Eigen::Vector3d& point, const RobotFootprint& footprint) {
  return std::abs(point.x()) <= footprint.length_m / 2.0 &&
         std::abs(point.y()) <= footprint.width_m / 2.0;
}

std::pair<float, float> span_of(const std::vector<float>& times_s) {
  const auto [first, last] = std::minmax_element(times_s.begin(), times_s.end());
  return {*first, *last};
}

}  // namespace

std::shared_ptr<const RangeSensor> CloudRing::ring_at(const Point2& place, double max_range_m) {
  constexpr std::size_t kMostRings = 8;  // a sensor that keeps moving is taken as it was at first
  for (const auto& ring : rings_) {
    if ((ring->robot_from_beam.front().position() - place).norm() < kSamePlaceM) return ring;
  }
  if (rings_.size() >= kMostRings) return rings_.front();
  auto ring = std::make_shared<RangeSensor>();
  ring->max_range_m = static_cast<double>(static_cast<float>(max_range_m));
  for (int i = 0; i < kBearings; ++i) {
    ring->robot_from_beam.push_back(
        {place.x(), place.y(), wrap_angle(-kPi + (i + 0.5) * kStepRad)});
  }
  rings_.push_back(std::move(ring));
  return rings_.back();
}

RangeReading CloudRing::read(const CloudMessage& cloud, const Transform3& base_from_cloud,
                             const CloudSlice& slice, const SweepPath& path) {
  const Point2 place = planar(base_from_cloud).position();
  RangeReading reading;
  reading.sensor = ring_at(place, slice.max_range_m);
  const Point2 centre = reading.sensor->robot_from_beam.front().position();
  reading.ranges_m.assign(kBearings, std::numeric_limits<float>::quiet_NaN());
  const bool moves = path.moves() && cloud.times_s.size() == cloud.points.size();
  const auto [first_s, last_s] = moves ? span_of(cloud.times_s) : std::pair(0.0F, 1.0F);
  ++clouds_;
  if (moves) ++unrolled_;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const Eigen::Vector3d at = base_from_cloud * cloud.points[i].cast<double>();
    ++points_;
    const bool is_in_band = slice.is_flat || (at.z() >= slice.low_m && at.z() <= slice.high_m);
    if (!is_in_band || is_of_the_robot(at, slice.footprint)) continue;
    Point2 seen(at.x(), at.y());
    if (moves) {
      const float share = (cloud.times_s[i] - first_s) / (last_s - first_s);
      seen = path.at(static_cast<double>(share)) * seen;
    }
    const Point2 off = seen - centre;
    const double range_m = off.norm();
    if (range_m < kLeastRangeM || range_m >= slice.max_range_m) continue;
    ++taken_;
    const double bearing = (std::atan2(off.y(), off.x()) + kPi) / kStepRad;
    float& nearest_m = reading.ranges_m[static_cast<std::size_t>(
        std::clamp(static_cast<int>(bearing), 0, kBearings - 1))];
    if (!(nearest_m <= static_cast<float>(range_m))) nearest_m = static_cast<float>(range_m);
  }
  return reading;
}

}  // namespace roomatlas::io
