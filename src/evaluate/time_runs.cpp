// SPDX-License-Identifier: GPL-3.0-or-later
#include "time_runs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomatlas::evaluation {
namespace {

/// Two times are the same when these are.
std::optional<long long> microseconds(double time_s) {
  constexpr double kLimit_s = 9e12;  // a long long holds no more microseconds
  if (!(std::abs(time_s) < kLimit_s)) return std::nullopt;
  return std::llround(time_s * 1e6);
}

}  // namespace

TimeRuns::TimeRuns(const std::vector<double>& times_s) {
  for (std::size_t place = 0; place < times_s.size(); ++place) {
    if (!std::isfinite(times_s[place])) continue;
    const bool steps_back = !entries_.empty() && times_s[place] < entries_.back().time_s;
    if (entries_.empty() || steps_back) runs_.push_back({entries_.size(), entries_.size()});
    entries_.push_back({times_s[place], place});
    runs_.back().end = entries_.size();
  }
}

std::size_t TimeRuns::after_in(const Run& run, double time_s) const {
  const auto begin = entries_.begin();
  const auto found = std::upper_bound(
      begin + static_cast<std::ptrdiff_t>(run.begin), begin + static_cast<std::ptrdiff_t>(run.end),
      time_s, [](double t, const Entry& entry) { return t < entry.time_s; });
  return static_cast<std::size_t>(found - begin);
}

std::optional<TimeRuns::Bracket> TimeRuns::enclosing(double time_s, std::size_t first) const {
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const Run& run = runs_[(first + i) % runs_.size()];
    const bool inside =
        time_s >= entries_[run.begin].time_s && time_s <= entries_[run.end - 1].time_s;
    if (!inside) continue;
    std::size_t after = after_in(run, time_s);
    std::size_t before = after - 1;
    if (entries_[before].time_s < time_s)
      return Bracket{entries_[before].place, entries_[after].place};
    while (before > run.begin && entries_[before - 1].time_s == time_s) --before;
    return Bracket{entries_[before].place, entries_[before].place};
  }
  return std::nullopt;
}

std::optional<std::size_t> TimeRuns::nearest(double time_s) const {
  std::optional<std::size_t> found;
  double least_s = std::numeric_limits<double>::infinity();
  const auto consider = [&](std::size_t entry) {
    const double away_s = std::abs(entries_[entry].time_s - time_s);
    if (!(away_s < least_s)) return;
    least_s = away_s;
    found = entries_[entry].place;
  };
  for (const Run& run : runs_) {
    const std::size_t after = after_in(run, time_s);
    if (after > run.begin) {
      std::size_t before = after - 1;
      while (before > run.begin && entries_[before - 1].time_s == entries_[before].time_s) --before;
      consider(before);
    }
    if (after < run.end) consider(after);
  }
  return found;
}

std::optional<std::size_t> TimeRuns::latest_before(double time_s) const {
  std::optional<std::size_t> found;
  std::optional<std::size_t> earliest;
  for (const Run& run : runs_) {
    if (!earliest || entries_[run.begin].time_s < entries_[*earliest].time_s) earliest = run.begin;
    const std::size_t after = after_in(run, time_s);
    if (after == run.begin) continue;
    if (!found || entries_[after - 1].time_s > entries_[*found].time_s) found = after - 1;
  }
  if (!found) found = earliest;
  if (!found) return std::nullopt;
  return entries_[*found].place;
}

std::optional<std::size_t> TimeRuns::same_microsecond(double time_s, std::size_t first) const {
  const auto wanted = microseconds(time_s);
  if (!wanted) return std::nullopt;
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const Run& run = runs_[(first + i) % runs_.size()];
    for (std::size_t entry = after_in(run, time_s - 2e-6); entry < run.end; ++entry) {
      const auto found = microseconds(entries_[entry].time_s);
      if (found == wanted) return entries_[entry].place;
      if (!found || *found > *wanted) break;
    }
  }
  return std::nullopt;
}

std::size_t TimeRuns::run_of(std::size_t place) const {
  for (std::size_t run = 0; run + 1 < runs_.size(); ++run) {
    if (place < entries_[runs_[run + 1].begin].place) return run;
  }
  return runs_.empty() ? 0 : runs_.size() - 1;
}

}  // namespace roomatlas::evaluation
