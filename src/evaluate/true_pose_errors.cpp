// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "roomatlas/evaluate/evaluate.hpp"

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

}  // namespace

TruePoseErrors true_pose_errors(const Trajectory& trajectory, const Trajectory& truth) {
  TruePoseErrors result;
  result.poses = std::ssize(trajectory);
  TruthReader reader(truth);
  std::vector<double> position_m;
  std::vector<double> heading_deg;
  for (const auto& [timestamp_s, building_from_robot] : trajectory) {
    const std::optional<Pose2> truth_from_robot = reader.next(timestamp_s);
    if (!truth_from_robot) continue;
    if (result.matched++ == 0) {
      result.truth_from_building = *truth_from_robot * inverse(building_from_robot);
    }
    const Pose2 error =
        inverse(*truth_from_robot) * (result.truth_from_building * building_from_robot);
    position_m.push_back(error.position().norm());
    heading_deg.push_back(degrees(std::abs(error.theta_rad)));
  }
  result.position_m = statistics(std::move(position_m));
  result.heading_deg = statistics(std::move(heading_deg));
  return result;
}

}  // namespace roomatlas
