// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/evaluate/true_poses.hpp"

namespace roomatlas {
namespace {

/// True poses at the timestamps of a trajectory, asked in file order. Remembers where it was:
/// where clocks stepped back one timestamp names several places of the file, and the next one on
/// from there is meant.
class TruthReader {
 public:
  explicit TruthReader(const Trajectory& truth) : truth_(truth) {
    for (const StampedPose& stamped : truth) {
      first_s_ = std::fmin(first_s_, stamped.timestamp_s);
      last_s_ = std::fmax(last_s_, stamped.timestamp_s);
    }
  }

  /// The true pose at a timestamp; nothing where no two neighbours enclose it.
  [[nodiscard]] std::optional<Pose2> next(double timestamp_s) {
    const bool stepped_back = timestamp_s < former_s_;
    former_s_ = timestamp_s;
    if (!(timestamp_s >= first_s_ && timestamp_s <= last_s_)) return std::nullopt;
    const std::size_t count = truth_.size();
    const std::size_t start = at_ + (stepped_back ? 1 : 0);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t from = (start + i) % count;
      if (const auto pose = between(from, std::min(from + 1, count - 1), timestamp_s)) {
        at_ = from;
        return pose;
      }
    }
    return std::nullopt;
  }

 private:
  /// A step back from one pose to the next spans no time: only its two ends count.
  [[nodiscard]] std::optional<Pose2> between(std::size_t from, std::size_t to,
                                             double timestamp_s) const {
    const StampedPose& a = truth_[from];
    const StampedPose& b = truth_[to];
    if (timestamp_s == a.timestamp_s) return a.pose;
    if (timestamp_s == b.timestamp_s) return b.pose;
    if (!(a.timestamp_s < timestamp_s && timestamp_s < b.timestamp_s)) return std::nullopt;
    const double fraction = (timestamp_s - a.timestamp_s) / (b.timestamp_s - a.timestamp_s);
    return interpolate(a.pose, b.pose, fraction);
  }

  const Trajectory& truth_;
  std::size_t at_ = 0;  ///< the place of the last answer
  double former_s_ = -std::numeric_limits<double>::infinity();
  double first_s_ = std::numeric_limits<double>::infinity();
  double last_s_ = -std::numeric_limits<double>::infinity();
};

/// A pose of the trajectory and the true pose at its time.
struct PosePair {
  Pose2 building_from_robot;
  Pose2 truth_from_robot;
};

std::vector<PosePair> matched(const Trajectory& trajectory, const Trajectory& truth) {
  std::vector<PosePair> pairs;
  TruthReader reader(truth);
  for (const auto& [timestamp_s, building_from_robot] : trajectory) {
    if (const auto truth_from_robot = reader.next(timestamp_s)) {
      pairs.push_back({building_from_robot, *truth_from_robot});
    }
  }
  return pairs;
}

/// The rigid motion that brings the positions nearest to the true ones, in the sum of squares
/// (Umeyama 1991, in the plane and without scale).
Pose2 least_squares_alignment(const std::vector<PosePair>& pairs) {
  Point2 mean_building = Point2::Zero();
  Point2 mean_truth = Point2::Zero();
  for (const PosePair& pair : pairs) {
    mean_building += pair.building_from_robot.position() / static_cast<double>(pairs.size());
    mean_truth += pair.truth_from_robot.position() / static_cast<double>(pairs.size());
  }
  double sine = 0.0;
  double cosine = 0.0;
  for (const PosePair& pair : pairs) {
    const Point2 from = pair.building_from_robot.position() - mean_building;
    const Point2 to = pair.truth_from_robot.position() - mean_truth;
    sine += cross(from, to);
    cosine += from.dot(to);
  }
  const Pose2 turn{0.0, 0.0, wrap_angle(std::atan2(sine, cosine))};
  const Point2 shift = mean_truth - turn * mean_building;
  return {shift.x(), shift.y(), turn.theta_rad};
}

}  // namespace

TruePoseErrors true_pose_errors(const Trajectory& trajectory, const Trajectory& truth) {
  TruePoseErrors result;
  result.poses = std::ssize(trajectory);
  const std::vector<PosePair> pairs = matched(trajectory, truth);
  result.matched = std::ssize(pairs);
  if (pairs.empty()) return result;
  const Pose2 aligned_at_first =
      pairs.front().truth_from_robot * inverse(pairs.front().building_from_robot);
  std::vector<double> position_m;
  std::vector<double> heading_deg;
  for (const auto& [building_from_robot, truth_from_robot] : pairs) {
    const Pose2 error = inverse(truth_from_robot) * (aligned_at_first * building_from_robot);
    position_m.push_back(error.position().norm());
    heading_deg.push_back(degrees(std::abs(error.theta_rad)));
  }
  result.position_m = statistics(std::move(position_m));
  result.heading_deg = statistics(std::move(heading_deg));
  result.truth_from_building = least_squares_alignment(pairs);
  return result;
}

}  // namespace roomatlas
