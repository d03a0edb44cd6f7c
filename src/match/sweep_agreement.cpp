// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep_agreement.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr std::size_t kPoints = 120;      // of a sweep that are compared; more cost more
constexpr double kTolerance_m = 0.10;     // of a point, and ...
constexpr double kToleranceShare = 0.02;  // ... of its range: headings are a degree wrong
constexpr double kCoarse_m = 0.15;        // steps of the search ...
constexpr double kCoarse_rad = radians(4.0);
constexpr double kCoarseTolerance = 1.5;  // ... and how much wider it looks
constexpr std::size_t kRefined = 8;       // best places that are looked at closely
constexpr int kRefinements = 3;           // each halves the steps

/// Counts the points of `b` in what `a` saw.
void count(const SeenSweep& a, const SeenSweep& b, const Pose2& a_from_b, double wider,
           Agreement& counts) {
  const PointTransform transform(a_from_b);
  const RangeProfile::Tolerance tolerance{wider * kTolerance_m, wider * kToleranceShare};
  for (const Point2& point : b.points) {
    switch (a.profile.place_of(transform * point, tolerance)) {
      case RangeProfile::Place::through:
        ++counts.contradicting;
        break;
      case RangeProfile::Place::there:
        ++counts.agreeing;
        break;
      default:
        break;
    }
  }
}

void count_both(const SeenSweep& a, const SeenSweep& b, const Pose2& a_from_b, double wider,
                Agreement& counts) {
  counts.points += static_cast<int>(a.points.size() + b.points.size());
  count(a, b, a_from_b, wider, counts);
  count(b, a, inverse(a_from_b), wider, counts);
}

using Side = std::vector<PlacedSweep>;

Agreement counted(const Side& a, const Side& b, const Pose2& a_from_b, double wider) {
  Agreement counts;
  for (const PlacedSweep& one : a) {
    const Pose2 one_from_b = inverse(one.side_from_sweep) * a_from_b;
    for (const PlacedSweep& other : b) {
      count_both(*one.seen, *other.seen, one_from_b * other.side_from_sweep, wider, counts);
    }
  }
  return counts;
}

struct Tried {
  Pose2 a_from_b;
  double share = -1.0;
};

/// Share at a pose; -1 where too little can be compared.
double share_at(const Side& a, const Side& b, const Pose2& a_from_b, double wider,
                double comparable_share) {
  const Agreement counts = counted(a, b, a_from_b, wider);
  if (counts.comparable() < comparable_share * counts.points || counts.points == 0) return -1.0;
  return counts.share();
}

/// All poses of the window, on its steps.
std::vector<Tried> tried_in(const Side& a, const Side& b, const Pose2& middle,
                            const SweepWindow& window, double comparable_share) {
  const int across = static_cast<int>(std::ceil(window.reach_m / kCoarse_m));
  const int turns = static_cast<int>(std::ceil(window.reach_rad / kCoarse_rad));
  std::vector<Tried> tried;
  for (int turn = -turns; turn <= turns; ++turn) {
    for (int x = -across; x <= across; ++x) {
      for (int y = -across; y <= across; ++y) {
        const Pose2 pose{middle.x_m + x * kCoarse_m, middle.y_m + y * kCoarse_m,
                         wrap_angle(middle.theta_rad + turn * kCoarse_rad)};
        tried.push_back({pose, share_at(a, b, pose, kCoarseTolerance, comparable_share)});
      }
    }
  }
  return tried;
}

/// Climbs to a better pose, by steps that become smaller.
Tried refined(const Side& a, const Side& b, const Pose2& start, double comparable_share) {
  Tried best{start, share_at(a, b, start, 1.0, comparable_share)};
  double step_m = kCoarse_m / 2.0;
  double step_rad = kCoarse_rad / 2.0;
  for (int round = 0; round < kRefinements; ++round, step_m /= 2.0, step_rad /= 2.0) {
    const Pose2 middle = best.a_from_b;
    for (int turn = -1; turn <= 1; ++turn) {
      for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
          const Pose2 pose{middle.x_m + x * step_m, middle.y_m + y * step_m,
                           wrap_angle(middle.theta_rad + turn * step_rad)};
          const double share = share_at(a, b, pose, 1.0, comparable_share);
          if (share > best.share) best = {pose, share};
        }
      }
    }
  }
  return best;
}

}  // namespace

SeenSweep seen_sweep(const RangeReading& reading) {
  const RangeSensor& sensor = *reading.sensor;
  Point2 eye = Point2::Zero();
  for (const Pose2& beam : sensor.robot_from_beam) eye += beam.position();
  if (!sensor.robot_from_beam.empty()) eye /= static_cast<double>(sensor.robot_from_beam.size());
  std::vector<Point2> points;
  for (std::size_t i = 0; i < reading.ranges_m.size(); ++i) {
    const double range_m = reading.ranges_m[i];
    if (!(range_m > 0.0) || !(range_m < sensor.max_range_m)) continue;
    points.push_back(sensor.robot_from_beam[i] * Point2(range_m, 0.0));
  }
  SeenSweep seen{{}, RangeProfile(eye, points)};
  const std::size_t every = std::max<std::size_t>(1, (points.size() + kPoints - 1) / kPoints);
  for (std::size_t i = 0; i < points.size(); i += every) seen.points.push_back(points[i]);
  return seen;
}

double Agreement::share() const {
  return comparable() > 0 ? static_cast<double>(agreeing) / comparable() : 0.0;
}

Agreement agreement_of(const SeenSweep& a, const SeenSweep& b, const Pose2& a_from_b) {
  Agreement counts;
  count_both(a, b, a_from_b, 1.0, counts);
  return counts;
}

std::optional<double> best_agreement_near(const std::vector<PlacedSweep>& a,
                                          const std::vector<PlacedSweep>& b, const Pose2& a_from_b,
                                          const SweepWindow& window, double comparable_share) {
  if (a.empty() || b.empty()) return std::nullopt;
  // searched by the two nearest to the frames, then by all
  std::vector<Tried> tried = tried_in({a.front()}, {b.front()}, a_from_b, window, comparable_share);
  const std::size_t most = std::min(kRefined, tried.size());
  std::partial_sort(tried.begin(), tried.begin() + static_cast<std::ptrdiff_t>(most), tried.end(),
                    [](const Tried& x, const Tried& y) { return x.share > y.share; });
  double best = -1.0;
  for (std::size_t i = 0; i < most && tried[i].share >= 0.0; ++i) {
    best = std::max(best, refined(a, b, tried[i].a_from_b, comparable_share).share);
  }
  if (best < 0.0) return std::nullopt;
  return best;
}

}  // namespace roomatlas
