// SPDX-License-Identifier: GPL-3.0-or-later
// Rays, hits and free space: what the readings say.
#include <algorithm>
#include <cmath>

#include "consistency_figures.hpp"

namespace roomatlas {
namespace {

constexpr std::size_t kRayStride = 5;  ///< every fifth ray is asked; walls are many

/// How a ray meets the walls of another ASR: where it ends less where the first wall stands, in
/// metres along the ray; nothing when no wall is on its way, up to `reach_m` behind its end.
std::optional<double> behind_wall_m(const Segment2& ray, const std::vector<Segment2>& walls,
                                    double reach_m) {
  const Point2 along = ray.b - ray.a;
  const double length_m = along.norm();
  if (!(length_m > 0.0)) return std::nullopt;
  const Segment2 longer{ray.a, ray.b + reach_m * along / length_m};
  std::optional<double> first;
  for (const Segment2& wall : walls) {
    const auto at = crossing_fraction(longer, wall);
    if (at && (!first || *at < *first)) first = *at;
  }
  if (!first) return std::nullopt;
  return length_m - *first * (length_m + reach_m);
}

}  // namespace

ConsistencyValue rays_through_walls(const PlacedAll& all, const ConsistencyOptions& options) {
  std::int64_t met = 0;
  std::int64_t through = 0;
  for (const PlacedEvidence& a : all) {
    for (const PlacedEvidence& b : all) {
      if (&a == &b || !near(a, b, 0.0)) continue;
      const Pose2 b_from_a = inverse(b.building_from_asr) * a.building_from_asr;
      const auto& rays = a.evidence->rays;
      for (std::size_t i = 0; i < rays.size(); i += kRayStride) {
        const auto behind_m = behind_wall_m(transformed(b_from_a, rays[i].segment),
                                            b.evidence->walls, options.deep_m);
        if (!behind_m) continue;
        if (!rays[i].is_hit && *behind_m < options.deep_m) continue;  // it says nothing of the wall
        ++met;
        if (*behind_m > options.deep_m) ++through;
      }
    }
  }
  ConsistencyValue result{ConsistencyFigure::rays_through_walls};
  result.measured = static_cast<double>(met);
  if (met > 0) result.value = static_cast<double>(through) / result.measured;
  return result;
}

HitFigures judge_hits(const PlacedAll& all, const ConsistencyOptions& options) {
  std::int64_t seen = 0;
  std::int64_t in_free_space = 0;
  std::int64_t paired = 0;
  double apart_sum_m = 0.0;
  for (const PlacedEvidence& a : all) {
    for (const PlacedEvidence& b : all) {
      if (&a == &b || !near(a, b, options.doubled_reach_m)) continue;
      const Pose2 b_from_a = inverse(b.building_from_asr) * a.building_from_asr;
      for (const MeasuredRay& ray : a.evidence->rays) {
        if (!ray.is_hit) continue;
        const Point2 hit = b_from_a * ray.segment.b;
        const auto apart_m = b.evidence->seen.distance_to_hit(hit, options.doubled_reach_m);
        const bool is_free = b.evidence->seen.free_rays(hit) >= options.min_free_rays;
        if (apart_m) {
          ++paired;
          apart_sum_m += *apart_m;
        }
        if (!apart_m && !is_free) continue;
        ++seen;
        if (!apart_m) ++in_free_space;
      }
    }
  }
  HitFigures figures{{ConsistencyFigure::hits_in_free_space}, {ConsistencyFigure::doubled_walls}};
  figures.in_free_space.measured = static_cast<double>(seen);
  figures.doubled_walls.measured = static_cast<double>(paired);
  if (seen > 0)
    figures.in_free_space.value =
        static_cast<double>(in_free_space) / figures.in_free_space.measured;
  if (paired > 0) figures.doubled_walls.value = apart_sum_m / figures.doubled_walls.measured;
  return figures;
}

}  // namespace roomatlas
