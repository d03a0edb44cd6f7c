// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/match/kidnapping.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>

#include "sweep_agreement.hpp"

namespace roomatlas {
namespace {

struct Sweep {
  std::int64_t number = 0;
  double timestamp_s = 0.0;
  double before_s = 0.0;  ///< time of the reading before
  Pose2 odom_from_robot;
  SeenSweep seen;
};

/// What is granted to odometry between two sweeps.
SweepWindow window_between(const Sweep& a, const Sweep& b, const KidnappingOptions& options) {
  const double time_s = std::max(0.0, b.timestamp_s - a.timestamp_s);
  const Pose2 step = inverse(a.odom_from_robot) * b.odom_from_robot;
  SweepWindow window;
  window.reach_m = std::min(options.most_reach_m, options.reach_m + options.reach_m_per_s * time_s +
                                                      0.5 * step.position().norm());
  window.reach_rad = options.reach_rad + 0.5 * std::abs(step.theta_rad);
  return window;
}

}  // namespace

struct KidnappingFinder::State {
  explicit State(const KidnappingOptions& given) : options(given) {}

  /// Whether a side's sweeps fit each other where odometry has them.
  [[nodiscard]] bool is_course(std::size_t first, std::size_t last) const {
    for (std::size_t i = first; i + 1 < last; ++i) {
      for (std::size_t j = i + 1; j < last; ++j) {
        const Pose2 step = inverse(sweeps[i].odom_from_robot) * sweeps[j].odom_from_robot;
        const Agreement fits = agreement_of(sweeps[i].seen, sweeps[j].seen, step);
        if (fits.points < options.least_points || !is_enough(fits)) return false;
        if (fits.share() < options.course_share) return false;
      }
    }
    return true;
  }

  [[nodiscard]] bool is_enough(const Agreement& agreement) const {
    return agreement.comparable() >= options.comparable_share * agreement.points;
  }

  /// The sweeps of a side as odometry has them, the nearest to the cut first.
  [[nodiscard]] std::vector<PlacedSweep> side_of(std::size_t nearest, int step) const {
    std::vector<PlacedSweep> side;
    const Pose2 side_from_odom = inverse(sweeps[nearest].odom_from_robot);
    for (int i = 0; i < options.sweeps; ++i) {
      const int at = static_cast<int>(nearest) + i * step;
      const Sweep& sweep = sweeps[static_cast<std::size_t>(at)];
      side.push_back({&sweep.seen, side_from_odom * sweep.odom_from_robot});
    }
    return side;
  }

  [[nodiscard]] std::optional<double> agreement_across(std::size_t cut) const {
    const Sweep& before = sweeps[cut - 1];
    const Sweep& after = sweeps[cut];
    return best_agreement_near(side_of(cut - 1, -1), side_of(cut, 1),
                               inverse(before.odom_from_robot) * after.odom_from_robot,
                               window_between(before, after, options), options.comparable_share);
  }

  /// Judges the sweep in the middle, once all around it are there.
  void judge() {
    const auto side = static_cast<std::size_t>(options.sweeps);
    if (sweeps.size() < 2 * side) return;
    const Sweep& before = sweeps[side - 1];
    const Sweep& after = sweeps[side];
    const Agreement as_told = agreement_of(before.seen, after.seen,
                                           inverse(before.odom_from_robot) * after.odom_from_robot);
    const bool is_suspect = !is_enough(as_told) || as_told.share() < options.suspect_share;
    if (is_suspect && is_course(0, side) && is_course(side, sweeps.size())) {
      const auto best = agreement_across(side);
      if (best && *best <= options.broken_share) {
        found.push_back({after.number, after.before_s, after.timestamp_s, *best});
      }
    }
    sweeps.pop_front();
  }

  KidnappingOptions options;
  std::shared_ptr<const RangeSensor> sensor;  ///< that is listened to: the first laser
  std::deque<Sweep> sweeps;
  std::int64_t readings = 0;
  double last_s = 0.0;
  std::vector<Kidnapping> found;
};

KidnappingFinder::KidnappingFinder(const KidnappingOptions& options)
    : state_(std::make_unique<State>(options)) {}
KidnappingFinder::~KidnappingFinder() = default;

void KidnappingFinder::add(const RangeReading& reading) {
  State& state = *state_;
  const std::int64_t number = state.readings++;
  const double before_s = std::exchange(state.last_s, reading.timestamp_s);
  if (reading.sensor->kind != SensorKind::laser) return;
  if (!state.sensor) state.sensor = reading.sensor;
  if (reading.sensor != state.sensor) return;
  if (!state.sweeps.empty()) {
    const double apart_s = reading.timestamp_s - state.sweeps.back().timestamp_s;
    if (apart_s >= 0.0 && apart_s < state.options.apart_s) return;
  }
  state.sweeps.push_back(
      {number, reading.timestamp_s, before_s, reading.odom_from_robot, seen_sweep(reading)});
  state.judge();
}

const std::vector<Kidnapping>& KidnappingFinder::found() const { return state_->found; }

std::vector<Kidnapping> find_kidnappings(MissionSource& mission, const KidnappingOptions& options) {
  KidnappingFinder finder(options);
  while (const auto event = mission.next()) {
    if (const auto* reading = std::get_if<RangeReading>(&*event)) finder.add(*reading);
  }
  return finder.found();
}

}  // namespace roomatlas
