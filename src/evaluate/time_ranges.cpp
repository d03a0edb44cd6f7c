// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/time_ranges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace roomatlas {
namespace {

std::string text_of(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

struct TimeUnit {
  const char* name;
  double per_second;
};
/// Earlier first times do not count from 1970, but from the start of a program.
constexpr double kFromZero_s = 1000.0;
/// From fine to coarse.
constexpr std::array kUnits = {TimeUnit{"nanoseconds", 1e9}, TimeUnit{"microseconds", 1e6},
                               TimeUnit{"milliseconds", 1e3}};

/// The unit in which times of our age are this large; null for seconds.
const TimeUnit* unit_of(double largest) {
  constexpr double kYear2200_s = 7.3e9;  // since 1970
  const TimeUnit* found = nullptr;
  for (const TimeUnit& unit : kUnits) {  // the coarsest in which they are of our age
    if (largest > kYear2200_s && largest / unit.per_second <= kYear2200_s) found = &unit;
  }
  return found;
}

double length_s(const TimeRange& range) { return range.last_s - range.first_s; }

/// The unit of the longer one, where both would be of one length in it; null where none fits.
const TimeUnit* unit_between(const TimeRange& longer, const TimeRange& shorter) {
  if (!(length_s(shorter) > 0.0)) return nullptr;
  for (const TimeUnit& unit : kUnits) {
    const double ratio = length_s(longer) / unit.per_second / length_s(shorter);
    if (ratio > 0.5 && ratio < 2.0) return &unit;
  }
  return nullptr;
}

std::string convert(const char* whose, const TimeUnit& unit) {
  return std::string("; the ") + whose + " times look like " + unit.name + ": divide them by " +
         text_of("%.0e", unit.per_second) + " to have seconds";
}

bool overlap(const TimeRange& a, const TimeRange& b) {
  return a.first_s <= b.last_s && b.first_s <= a.last_s;
}

}  // namespace

TimeRange time_range(const std::vector<double>& times_s) {
  TimeRange range;
  double former_s = 0.0;
  for (const double time_s : times_s) {
    if (!std::isfinite(time_s)) continue;
    if (range.count++ == 0) {
      range.first_s = range.last_s = time_s;
    } else if (time_s < former_s) {
      ++range.steps_back;
    }
    range.first_s = std::min(range.first_s, time_s);
    range.last_s = std::max(range.last_s, time_s);
    former_s = time_s;
  }
  return range;
}

std::vector<double> times_of(const Trajectory& trajectory) {
  std::vector<double> times_s;
  times_s.reserve(trajectory.size());
  for (const StampedPose& stamped : trajectory) times_s.push_back(stamped.timestamp_s);
  return times_s;
}

TimeRange time_range(const Trajectory& trajectory) { return time_range(times_of(trajectory)); }

std::string to_string(const TimeRange& range) {
  if (range.count == 0) return "no times";
  return "[" + text_of("%.3f", range.first_s) + ", " + text_of("%.3f", range.last_s) + "] s";
}

std::string explain_mismatch(const std::vector<double>& trajectory_s,
                             const std::vector<double>& truth_s) {
  const TimeRange trajectory = time_range(trajectory_s);
  const TimeRange truth = time_range(truth_s);
  if (truth.count == 0) return "the truth is empty: give a file that holds relations or poses";
  if (trajectory.count == 0) return "the trajectory has no pose with a time";
  const std::string text = "no time of the truth " + to_string(truth) +
                           " has a pose of the trajectory " + to_string(trajectory);
  if (const TimeUnit* unit = unit_of(std::abs(trajectory.last_s))) {
    const TimeUnit* by_length = unit_between(trajectory, truth);
    return text + convert("trajectory's", by_length != nullptr ? *by_length : *unit);
  }
  if (const TimeUnit* unit = unit_of(std::abs(truth.last_s))) {
    const TimeUnit* by_length = unit_between(truth, trajectory);
    return text + convert("truth's", by_length != nullptr ? *by_length : *unit);
  }
  if (overlap(trajectory, truth)) {
    return text +
           "; the times overlap but none is equal: try --match nearest or --match interpolate";
  }
  if (const TimeUnit* unit = unit_between(trajectory, truth))
    return text + convert("trajectory's", *unit);
  if (const TimeUnit* unit = unit_between(truth, trajectory))
    return text + convert("truth's", *unit);

  std::string advice = text + "; the ranges do not meet. ";
  if (const auto fit = fitting_offset(trajectory_s, truth_s)) {
    advice += "An offset of " + text_of("%.3f", fit->offset_s) + " s fits " +
              text_of("%.0f", 100.0 * fit->share) + " % of the truth's times: --time-offset " +
              text_of("%.3f", fit->offset_s) + " --match nearest.";
  } else {
    const double offset_s = truth.first_s - trajectory.first_s;
    advice += "No offset fits most of the truth's times; " + text_of("%.3f", offset_s) +
              " s would bring the beginnings together (--time-offset " + text_of("%.3f", offset_s) +
              "). They last " + text_of("%.0f", length_s(trajectory)) + " s and " +
              text_of("%.0f", length_s(truth)) + " s: is it the same recording?";
  }
  if (trajectory.first_s < kFromZero_s && trajectory.first_s < truth.first_s) {
    advice += " Times that count from 0 may be a logger's: --stamps-from LOG takes the log's own";
  }
  return advice;
}

Issues check_trajectory(const Trajectory& trajectory, const std::string& name) {
  Issues issues;
  const auto add = [&](Severity severity, std::string message) {
    issues.push_back({severity, name, 0, "", std::move(message)});
  };
  if (trajectory.empty()) add(Severity::error, "holds no pose; name a trajectory or a mission log");
  if (trajectory.size() == 1) {
    add(Severity::warning, "holds one pose only: there is no motion to judge; is the file whole?");
  }
  const auto broken = std::count_if(trajectory.begin(), trajectory.end(), [](const auto& stamped) {
    const auto& [timestamp_s, pose] = stamped;
    return !std::isfinite(timestamp_s) || !pose.position().allFinite() ||
           !std::isfinite(pose.theta_rad);
  });
  if (broken > 0) {
    add(Severity::error,
        std::to_string(broken) + " of " + std::to_string(trajectory.size()) +
            " poses are NaN or infinite: what wrote them diverged; leave them out");
  }
  const TimeRange range = time_range(trajectory);
  if (const TimeUnit* unit = unit_of(std::abs(range.last_s))) {
    add(Severity::warning,
        "times up to " + text_of("%.6g", range.last_s) + convert("", *unit).substr(1));
  }
  if (range.steps_back > 0) {
    add(Severity::note,
        "the clock steps back " + std::to_string(range.steps_back) +
            " times; the file's order is kept, and the first of equal times answers");
  }
  return issues;
}

}  // namespace roomatlas
