// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/pose_lookup.hpp"

#include "roomatlas/evaluate/time_ranges.hpp"
#include "time_runs.hpp"

#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

namespace roomatlas {
namespace {

constexpr double kNearestGap_s = 0.5;  // more than a scan, less than what a robot drives far in

}  // namespace

const char* to_string(TimeMatch match) {
  switch (match) {
    case TimeMatch::nearest:
      return "nearest";
    case TimeMatch::interpolate:
      return "interpolate";
    case TimeMatch::exact:
      break;
  }
  return "exact";
}

double max_gap_s(const MatchOptions& options, bool carried) {
  if (options.match == TimeMatch::exact) return 0.0;
  if (options.max_gap_s) return *options.max_gap_s;
  if (carried) return 0.0;
  return options.match == TimeMatch::nearest ? kNearestGap_s
                                             : std::numeric_limits<double>::infinity();
}

std::string to_string(const MatchUse& use) {
  std::string text = std::to_string(use.poses()) + " poses:";
  const auto add = [&](std::int64_t count, const char* how) {
    if (count == 0) return;
    text += (text.back() == ':' ? " " : ", ") + std::to_string(count) + " " + how;
  };
  add(use.exact, "exact");
  add(use.nearest, "nearest");
  add(use.interpolated, "interpolated");
  add(use.carried, "carried by odometry");
  if (use.poses() == 0) return "no poses";
  if (use.exact == use.poses()) return text;
  char gap[64];
  std::snprintf(gap, sizeof gap, " (gaps up to %.3g s)", use.largest_gap_s);
  return text + gap;
}

void count(MatchUse& use, const FoundPose& found) {
  switch (found.by) {
    case FoundPose::By::exact:
      ++use.exact;
      break;
    case FoundPose::By::nearest:
      ++use.nearest;
      break;
    case FoundPose::By::interpolation:
      ++use.interpolated;
      break;
    case FoundPose::By::odometry:
      ++use.carried;
      break;
  }
  use.largest_gap_s = std::fmax(use.largest_gap_s, found.gap_s);
}

struct PoseLookup::State {
  State(const Trajectory& poses, const MatchOptions& options, const Trajectory* odometry)
      : trajectory(poses),
        match(options.match),
        gap_s(max_gap_s(options, odometry != nullptr)),
        runs(times_of(poses)) {
    if (odometry != nullptr) {
      carry = std::make_unique<PoseLookup>(*odometry, MatchOptions{TimeMatch::interpolate, {}});
    }
  }

  [[nodiscard]] std::optional<FoundPose> at(double timestamp_s, std::size_t first_run) {
    if (const auto place = runs.same_microsecond(timestamp_s, first_run)) {
      return answer(*place, trajectory[*place].pose, FoundPose::By::exact, 0.0);
    }
    if (match == TimeMatch::nearest) {
      if (auto found = nearest(timestamp_s)) return found;
    } else if (match == TimeMatch::interpolate) {
      if (auto found = interpolated(timestamp_s, first_run)) return found;
    }
    return carry ? carried(timestamp_s) : std::nullopt;
  }

  std::optional<FoundPose> answer(std::size_t place, const Pose2& pose, FoundPose::By by,
                                  double gap) {
    last_place = place;
    return FoundPose{pose, by, gap};
  }

  std::optional<FoundPose> nearest(double timestamp_s) {
    const auto place = runs.nearest(timestamp_s);
    if (!place) return std::nullopt;
    const double away_s = std::abs(trajectory[*place].timestamp_s - timestamp_s);
    if (!(away_s <= gap_s)) return std::nullopt;
    return answer(*place, trajectory[*place].pose, FoundPose::By::nearest, away_s);
  }

  std::optional<FoundPose> interpolated(double timestamp_s, std::size_t first_run) {
    const auto bracket = runs.enclosing(timestamp_s, first_run);
    if (!bracket) return std::nullopt;
    const StampedPose& before = trajectory[bracket->before];
    const StampedPose& after = trajectory[bracket->after];
    const double span_s = after.timestamp_s - before.timestamp_s;
    if (!(span_s <= gap_s)) return std::nullopt;
    if (span_s == 0.0) return answer(bracket->before, before.pose, FoundPose::By::exact, 0.0);
    const double fraction = (timestamp_s - before.timestamp_s) / span_s;
    return answer(bracket->before, interpolate(before.pose, after.pose, fraction),
                  FoundPose::By::interpolation, span_s);
  }

  std::optional<FoundPose> carried(double timestamp_s) {
    const auto place = runs.latest_before(timestamp_s);
    if (!place) return std::nullopt;
    const StampedPose& from = trajectory[*place];
    const auto odom_from_start = carry->at(from.timestamp_s);
    const auto odom_from_end = carry->at(timestamp_s);
    if (!odom_from_start || !odom_from_end) return std::nullopt;
    const Pose2 start_from_end = inverse(odom_from_start->pose) * odom_from_end->pose;
    return answer(*place, from.pose * start_from_end, FoundPose::By::odometry,
                  std::abs(timestamp_s - from.timestamp_s));
  }

  const Trajectory& trajectory;
  TimeMatch match;
  double gap_s;
  evaluation::TimeRuns runs;
  std::unique_ptr<PoseLookup> carry;
  std::size_t last_place = 0;
  double former_s = -std::numeric_limits<double>::infinity();
  std::size_t next_run = 0;
};

PoseLookup::PoseLookup(const Trajectory& trajectory, const MatchOptions& options,
                       const Trajectory* carry)
    : state_(std::make_unique<State>(trajectory, options, carry)) {}
PoseLookup::~PoseLookup() = default;
PoseLookup::PoseLookup(PoseLookup&&) noexcept = default;
PoseLookup& PoseLookup::operator=(PoseLookup&&) noexcept = default;

std::optional<FoundPose> PoseLookup::at(double timestamp_s) const {
  return state_->at(timestamp_s, 0);
}

std::optional<FoundPose> PoseLookup::next(double timestamp_s) {
  State& state = *state_;
  const bool steps_back = timestamp_s < state.former_s;
  state.former_s = timestamp_s;
  if (state.runs.runs() < 2) return state.at(timestamp_s, 0);
  auto found = state.at(timestamp_s, state.next_run + (steps_back ? 1 : 0));
  if (found) state.next_run = state.runs.run_of(state.last_place);
  return found;
}

double PoseLookup::nearest_s(double timestamp_s) const {
  const auto place = state_->runs.nearest(timestamp_s);
  if (!place) return std::numeric_limits<double>::infinity();
  return std::abs(state_->trajectory[*place].timestamp_s - timestamp_s);
}

}  // namespace roomatlas
