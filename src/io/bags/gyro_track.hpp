// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <deque>
#include <optional>

namespace roomatlas::io {

/// The turns of a gyro, added up over the last seconds by their stamps.
class GyroTrack {
 public:
  static constexpr std::int64_t kKept_ns = 10'000'000'000;
  static constexpr std::int64_t kLongestGap_ns = 200'000'000;  ///< over it nobody knows the turn
  static constexpr std::size_t kMost = 20'000;                 ///< samples

  /// A sample that is older than the one before is left out; one that is older by all that is kept
  /// begins anew: the clock was set back.
  void add(std::int64_t stamp_ns, const Eigen::Vector3d& turn_rad_per_s);
  /// The turn between two times about each of the gyro's axes, drift and all; nothing where a gap
  /// or an end of what is kept lies between.
  [[nodiscard]] std::optional<Eigen::Vector3d> turn(std::int64_t from_ns, std::int64_t to_ns) const;
  [[nodiscard]] std::optional<std::int64_t> newest_ns() const;

 private:
  struct Sample {
    std::int64_t stamp_ns = 0;
    Eigen::Vector3d rad_per_s = Eigen::Vector3d::Zero();
    Eigen::Vector3d turned_rad = Eigen::Vector3d::Zero();  ///< since the first
    int gaps = 0;                                          ///< before it
  };
  struct Turned {
    Eigen::Vector3d rad;
    int gaps = 0;
  };
  [[nodiscard]] std::optional<Turned> turned_at(std::int64_t stamp_ns) const;

  std::deque<Sample> samples_;  ///< by stamp
};

}  // namespace roomatlas::io
