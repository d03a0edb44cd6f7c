// SPDX-License-Identifier: GPL-3.0-or-later
#include "slanted_faces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "line_sums.hpp"
#include "roomatlas/grid/cells.hpp"
#include "straight_runs.hpp"

namespace roomatlas {
namespace {

constexpr double kBucket_m = 0.25;
constexpr double kSeed_m = 0.25;         // surfaces this near a seed give its first direction
constexpr double kSlantedBand_m = 0.04;  // off the line; larger makes coarser chords of a curve
constexpr double kTurn_rad = 12.0 * kPi / 180.0;  // of normals from the line's
constexpr double kTaken_m = 0.07;  // surfaces this near a face that was found are its own ...
constexpr double kTakenTurn_rad = 25.0 * kPi / 180.0;  // ... when they look its way
constexpr double kSeenStep_m = 0.1;                    // where a face was seen is told this finely
constexpr int kGapSteps = 4;                           // in a face
constexpr int kMostRounds = 40;       // of growing; a round adds a gap's length at each end
constexpr double kLeastWeight = 6.0;  // of what a seed's first direction rests on

class Grower {
 public:
  Grower(const std::vector<SurfacePoint>& surfaces, double min_support_m)
      : surfaces_(surfaces), min_support_m_(min_support_m), is_taken_(surfaces.size(), false) {
    for (std::size_t i = 0; i < surfaces.size(); ++i) buckets_[bucket(surfaces[i].at)].push_back(i);
  }

  std::vector<WallFace> found() {
    std::vector<std::size_t> seeds(surfaces_.size());
    std::iota(seeds.begin(), seeds.end(), std::size_t{0});
    std::stable_sort(seeds.begin(), seeds.end(), [&](std::size_t a, std::size_t b) {
      return surfaces_[a].weight > surfaces_[b].weight;
    });
    std::vector<WallFace> faces;
    for (const std::size_t seed : seeds) {
      if (is_taken_[seed]) continue;
      WallFace face = grown_from(surfaces_[seed]);
      if (face.seen.empty() || face.support_m() < min_support_m_) {
        is_taken_[seed] = true;
        continue;
      }
      take(face);
      faces.push_back(std::move(face));
    }
    return faces;
  }

 private:
  static std::pair<int, int> bucket(const Point2& at) {
    return {static_cast<int>(std::floor(at.x() / kBucket_m)),
            static_cast<int>(std::floor(at.y() / kBucket_m))};
  }

  /// Visits free surfaces in the buckets around a segment.
  template <typename Visit>
  void for_each_around(const Segment2& segment, double reach_m, Visit visit) const {
    const auto [x0, y0] = bucket(segment.a.cwiseMin(segment.b) - Point2::Constant(reach_m));
    const auto [x1, y1] = bucket(segment.a.cwiseMax(segment.b) + Point2::Constant(reach_m));
    for (int x = x0; x <= x1; ++x) {
      for (auto at = buckets_.lower_bound({x, y0});
           at != buckets_.end() && at->first <= std::pair(x, y1); ++at) {
        for (const std::size_t i : at->second) {
          if (!is_taken_[i]) visit(i);
        }
      }
    }
  }

  /// The line through surfaces by total least squares, looking their way.
  static WallFace line_through(const std::vector<SurfacePoint>& on) {
    const Point2 origin = on.front().at;
    LineSums sums;
    Point2 look = Point2::Zero();
    for (const SurfacePoint& one : on) {
      sums.add(one.at - origin, one.weight);
      look += one.weight * direction(one.normal_rad);
    }
    const FittedLine line = sums.line();
    WallFace face;
    face.normal_rad = line.direction_rad + kPi / 2.0;
    if (direction(face.normal_rad).dot(look) < 0.0) face.normal_rad += kPi;
    face.normal_rad = wrap_angle(face.normal_rad);
    face.offset_m = (origin + line.middle).dot(face.normal());
    return face;
  }

  WallFace grown_from(const SurfacePoint& seed) const {
    std::vector<SurfacePoint> on;
    double weight = 0.0;
    for_each_around({seed.at, seed.at}, kSeed_m, [&](std::size_t i) {
      const SurfacePoint& one = surfaces_[i];
      if ((one.at - seed.at).norm() > kSeed_m) return;
      if (std::abs(wrap_angle(one.normal_rad - seed.normal_rad)) > kTurn_rad) return;
      on.push_back(one);
      weight += one.weight;
    });
    if (on.size() < 3 || weight < kLeastWeight) return {};
    WallFace face = line_through(on);
    const double middle_m = seed.at.dot(face.along());
    face.seen = {{middle_m - kSeed_m, middle_m + kSeed_m}};
    for (int round = 0; round < kMostRounds; ++round) {
      const Interval before{face.low_m(), face.high_m()};
      const Point2 middle = face.at((before.low_m + before.high_m) / 2.0);
      if (!grow(face, middle)) return {};
      const bool is_settled = std::abs(face.low_m() - before.low_m) < kSeenStep_m &&
                              std::abs(face.high_m() - before.high_m) < kSeenStep_m;
      if (is_settled && round > 1) break;
    }
    return face;
  }

  /// One round: what lies on the line around `middle`, and the line through that.
  bool grow(WallFace& face, const Point2& middle) const {
    const double reach_m = kGapSteps * kSeenStep_m;
    const Interval within{face.low_m() - reach_m, face.high_m() + reach_m};
    const Segment2 segment{face.at(within.low_m), face.at(within.high_m)};
    const Point2 normal = face.normal();
    const Point2 along = face.along();
    std::vector<SurfacePoint> on;
    std::vector<int> steps;
    for_each_around(segment, kSlantedBand_m, [&](std::size_t i) {
      const SurfacePoint& one = surfaces_[i];
      const double along_m = one.at.dot(along);
      if (std::abs(one.at.dot(normal) - face.offset_m) > kSlantedBand_m) return;
      if (std::abs(wrap_angle(one.normal_rad - face.normal_rad)) > kTurn_rad) return;
      if (along_m < within.low_m || along_m > within.high_m) return;
      on.push_back(one);
      steps.push_back(static_cast<int>(std::floor(along_m / kSeenStep_m)));
    });
    std::sort(steps.begin(), steps.end());
    const int at = static_cast<int>(std::floor(middle.dot(along) / kSeenStep_m));
    for (const auto& [first, last] : runs_of(steps, kGapSteps)) {
      if (steps[last] < at - kGapSteps || steps[first] > at + kGapSteps) continue;
      const double low_m = steps[first] * kSeenStep_m;
      const double high_m = (steps[last] + 1) * kSeenStep_m;
      std::erase_if(on, [&](const SurfacePoint& one) {
        const double along_m = one.at.dot(along);
        return along_m < low_m || along_m > high_m;
      });
      if (on.size() < 3) return false;
      face = line_through(on);
      face.seen = stretches_of(on, face);
      return true;
    }
    return false;
  }

  static std::vector<Interval> stretches_of(const std::vector<SurfacePoint>& on,
                                            const WallFace& face) {
    const Point2 along = face.along();
    std::vector<int> steps;
    steps.reserve(on.size());
    for (const SurfacePoint& one : on) {
      steps.push_back(static_cast<int>(std::floor(one.at.dot(along) / kSeenStep_m)));
    }
    std::sort(steps.begin(), steps.end());
    std::vector<Interval> seen;
    for (const auto& [first, last] : runs_of(steps, kGapSteps)) {
      seen.push_back({steps[first] * kSeenStep_m, (steps[last] + 1) * kSeenStep_m});
    }
    return seen;
  }

  void take(const WallFace& face) {
    const Segment2 segment{face.at(face.low_m()), face.at(face.high_m())};
    const Interval within{face.low_m() - kSeenStep_m, face.high_m() + kSeenStep_m};
    const Point2 normal = face.normal();
    const Point2 along = face.along();
    std::vector<std::size_t> taken;
    for_each_around(segment, kTaken_m, [&](std::size_t i) {
      const SurfacePoint& one = surfaces_[i];
      const double along_m = one.at.dot(along);
      const bool is_on = std::abs(one.at.dot(normal) - face.offset_m) <= kTaken_m &&
                         along_m > within.low_m && along_m < within.high_m &&
                         std::abs(wrap_angle(one.normal_rad - face.normal_rad)) <= kTakenTurn_rad;
      if (is_on) taken.push_back(i);
    });
    for (const std::size_t i : taken) is_taken_[i] = true;
  }

  const std::vector<SurfacePoint>& surfaces_;
  double min_support_m_;
  std::vector<bool> is_taken_;
  std::map<std::pair<int, int>, std::vector<std::size_t>> buckets_;
};

}  // namespace

std::vector<WallFace> slanted_faces(const std::vector<SurfacePoint>& surfaces,
                                    double min_support_m) {
  return Grower(surfaces, min_support_m).found();
}

}  // namespace roomatlas
