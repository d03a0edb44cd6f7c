// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/pose2.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace roomatlas {

/// How a trajectory answers for a time that it has no pose at.
enum class TimeMatch {
  exact,        ///< not at all; times are equal to the microsecond, which is what files carry
  nearest,      ///< by the pose nearest in time
  interpolate,  ///< by its two neighbours: positions linearly, headings along the shorter arc
};
[[nodiscard]] const char* to_string(TimeMatch match);

struct MatchOptions {
  TimeMatch match = TimeMatch::exact;
  /// Nearest: a pose farther away in time does not answer. Interpolate: neighbours farther apart
  /// do not. Nothing: 0.5 s for nearest and no limit for interpolate, or 0 where gaps are carried.
  std::optional<double> max_gap_s{};
};

/// The gap that holds where the options name none.
[[nodiscard]] double max_gap_s(const MatchOptions& options, bool carried);

/// Where the poses that were asked for came from.
struct MatchUse {
  std::int64_t exact = 0;
  std::int64_t nearest = 0;
  std::int64_t interpolated = 0;
  std::int64_t carried = 0;    ///< by relative odometry
  double largest_gap_s = 0.0;  ///< nearest: to the pose; interpolated: between the neighbours;
                               ///< carried: from the pose before

  [[nodiscard]] std::int64_t poses() const { return exact + nearest + interpolated + carried; }
};
/// "3370 poses: 100 exact, 3270 interpolated (gaps up to 1.2 s)".
[[nodiscard]] std::string to_string(const MatchUse& use);

/// A pose for a time, and how it was come by.
struct FoundPose {
  Pose2 pose;
  enum class By { exact, nearest, interpolation, odometry } by = By::exact;
  double gap_s = 0.0;
};
void count(MatchUse& use, const FoundPose& found);

/// Answers for times with poses of a trajectory whose clock may step back. File order is the true
/// order; where a time occurs more than once, the first place in the file answers. Poses whose
/// time is not finite do not answer.
class PoseLookup {
 public:
  /// @param carry odometry that fills gaps: a pose is then the latest one before it, moved on by
  ///   what odometry says of the time between (before the first pose: moved back from that one).
  ///   May be null. Both trajectories must outlive the lookup.
  PoseLookup(const Trajectory& trajectory, const MatchOptions& options,
             const Trajectory* carry = nullptr);
  ~PoseLookup();
  PoseLookup(PoseLookup&&) noexcept;
  PoseLookup& operator=(PoseLookup&&) noexcept;

  [[nodiscard]] std::optional<FoundPose> at(double timestamp_s) const;

  /// As `at`, for times asked in the file order of another recording of the same clock: where
  /// that steps back, one time names several places, and the next one on is meant.
  [[nodiscard]] std::optional<FoundPose> next(double timestamp_s);

  /// Seconds to the nearest pose; infinity without poses.
  [[nodiscard]] double nearest_s(double timestamp_s) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace roomatlas
