// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/match/recent_sweeps.hpp"

#include <cmath>

namespace roomatlas {
namespace {

std::vector<Point2> hits_of(const Scan& scan, const Pose2& map_from_robot) {
  const PointTransform place(map_from_robot);
  std::vector<Point2> hits;
  for (const ScanPoint& point : scan.points) {
    if (point.is_hit) hits.push_back(place * point.position);
  }
  return hits;
}

/// Points around a place, and how they are spread there.
class Spread {
 public:
  void add(const Point2& off) {
    ++count_;
    sum_ += off;
    squares_.noalias() += off * off.transpose();
  }
  [[nodiscard]] int count() const { return count_; }

  /// The direction across the line that the points lie on; zero where they are no line.
  [[nodiscard]] Point2 across(double max_flatness) const {
    const Point2 mean = sum_ / count_;
    const Eigen::Matrix2d spread = squares_ / count_ - mean * mean.transpose();
    const double half_trace = spread.trace() / 2.0;
    const double root = std::hypot((spread(0, 0) - spread(1, 1)) / 2.0, spread(0, 1));
    if (half_trace - root > max_flatness * (half_trace + root)) return Point2::Zero();
    return direction(std::atan2(2.0 * spread(0, 1), spread(0, 0) - spread(1, 1)) / 2.0 + kPi / 2.0);
  }

 private:
  int count_ = 0;
  Point2 sum_ = Point2::Zero();
  Eigen::Matrix2d squares_ = Eigen::Matrix2d::Zero();
};

}  // namespace

void RecentSweeps::add(const Scan& scan, const Pose2& map_from_robot) {
  if (!sweeps_.empty()) {
    const Pose2 moved = inverse(sweeps_.back().map_from_robot) * map_from_robot;
    if (moved.position().norm() < options_.apart_m &&
        std::abs(moved.theta_rad) < options_.apart_rad) {
      return;
    }
  }
  sweeps_.push_back({map_from_robot, hits_of(scan, map_from_robot)});
  if (sweeps_.size() > static_cast<std::size_t>(options_.kept)) sweeps_.pop_front();
}

void RecentSweeps::add_normals(Scan& scan, const Pose2& map_from_robot) const {
  const double near_m2 = options_.surface_m * options_.surface_m;
  const std::vector<Point2> own = hits_of(scan, map_from_robot);
  const Pose2 robot_from_map = inverse(map_from_robot);
  auto hit = own.begin();
  for (ScanPoint& point : scan.points) {
    if (!point.is_hit) continue;
    const Point2 at = *hit++;
    if (point.normal.squaredNorm() > 0.0) continue;
    Spread spread;
    const auto add_near = [&](const std::vector<Point2>& hits) {
      for (const Point2& other : hits) {
        if ((other - at).squaredNorm() < near_m2) spread.add(other - at);
      }
    };
    add_near(own);
    for (const Sweep& sweep : sweeps_) add_near(sweep.hits_map);
    if (spread.count() < options_.min_points) continue;
    const Point2 normal =
        Pose2{0.0, 0.0, robot_from_map.theta_rad} * spread.across(options_.max_flatness);
    const bool looks_away = normal.dot(scan.sensor - point.position) < 0.0;
    point.normal = looks_away ? Point2(-normal) : normal;
  }
}

}  // namespace roomatlas
