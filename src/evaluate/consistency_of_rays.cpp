// SPDX-License-Identifier: GPL-3.0-or-later
// Rays, hits and free space: what the readings say.
#include <algorithm>
#include <cmath>

#include "consistency_figures.hpp"
#include "roomatlas/core/for_each_index.hpp"

namespace roomatlas {
namespace {

constexpr std::size_t kRayStride = 5;    ///< every fifth ray is asked: walls are many
constexpr std::size_t kHitStride = 3;    ///< every third hit
constexpr std::size_t kManyVisits = 64;  ///< near a visit: twice as many are asked of half each

using Others = std::vector<const PlacedEvidence*>;

/// Every so manieth ray of a visit. Where a building was driven often, each of the others is asked
/// of a share of them, in turn: a visit asks no more however many lie near it, and asks of all.
/// @param near the others, and perhaps itself
/// @param ask takes the ray's number, the ray in the other's frame, and the other
template <typename Ask>
void for_each_asked(const PlacedEvidence& a, Others near, std::size_t stride, const Ask& ask) {
  std::erase(near, &a);
  const auto& rays = a.evidence->rays;
  const std::size_t shares = std::max<std::size_t>(1, near.size() / kManyVisits);
  for (std::size_t k = 0; k < near.size(); ++k) {
    const PointTransform b_from_a(inverse(near[k]->building_from_asr) * a.building_from_asr);
    for (std::size_t i = stride * (k % shares); i < rays.size(); i += stride * shares) {
      ask(i, transformed(b_from_a, rays[i].segment), *near[k]->evidence);
    }
  }
}

Box2 box_of(const Segment2& segment) {
  return {segment.a.cwiseMin(segment.b), segment.a.cwiseMax(segment.b)};
}

/// How a ray meets the walls of another ASR: where it ends less where the first wall stands, in
/// metres along the ray; nothing when no wall is on its way, up to `reach_m` behind its end.
std::optional<double> behind_wall_m(const Segment2& ray, const std::vector<Segment2>& walls,
                                    double reach_m) {
  const Point2 along = ray.b - ray.a;
  const double length_m = along.norm();
  if (!(length_m > 0.0)) return std::nullopt;
  const Segment2 longer{ray.a, ray.b + reach_m * along / length_m};
  const Box2 box = box_of(longer);
  std::optional<double> first;
  for (const Segment2& wall : walls) {
    if (!near(box, box_of(wall), 0.0)) continue;
    const auto at = crossing_fraction(longer, wall);
    if (at && (!first || *at < *first)) first = *at;
  }
  if (!first) return std::nullopt;
  return length_m - *first * (length_m + reach_m);
}

/// Adds what another visit saw at a hit. @return whether it saw that place
bool add(const NearHit& near_hit, bool is_free, double reach_m, VisitAgreement& sums) {
  if (!near_hit.is_near && !is_free) return false;
  ++sums.seen;
  if (!near_hit.is_near) ++sums.in_free_space;
  if (near_hit.is_near && !near_hit.across_m) return true;
  ++sums.compared;
  sums.apart_m += std::min(near_hit.across_m.value_or(reach_m), reach_m);
  return true;
}

/// The rays of one visit that come to walls of others.
struct RaysAtWalls {
  std::int64_t met = 0;
  std::int64_t through = 0;
};

RaysAtWalls rays_of(const PlacedEvidence& a, const NearAsrs& walls,
                    const ConsistencyOptions& options) {
  RaysAtWalls rays;
  const auto ask = [&](std::size_t i, const Segment2& ray, const AsrEvidence& b) {
    const auto behind_m = behind_wall_m(ray, b.walls, options.deep_m);
    if (!behind_m) return;
    // A ray without a hit that ends before the wall says nothing of it.
    if (!a.evidence->rays[i].is_hit && *behind_m < options.deep_m) return;
    ++rays.met;
    if (*behind_m > options.deep_m) ++rays.through;
  };
  for_each_asked(a, walls.near(a.seen), kRayStride, ask);
  return rays;
}

VisitAgreement judge_visit(const PlacedEvidence& a, const NearAsrs& seen,
                           const ConsistencyOptions& options) {
  const auto& rays = a.evidence->rays;
  VisitAgreement sums;
  sums.asr = a.evidence->asr;
  std::vector<bool> is_known(rays.size(), false);
  const auto ask = [&](std::size_t i, const Segment2& ray, const AsrEvidence& b) {
    if (!rays[i].is_hit) return;
    if (add(b.seen.nearest_hit(ray.b, ray.b - ray.a, options.deep_m),
            b.seen.free_rays(ray.b) >= options.min_free_rays, options.deep_m, sums)) {
      is_known[i] = true;
    }
  };
  for_each_asked(a, seen.near(a.seen), kHitStride, ask);
  for (std::size_t i = 0; i < rays.size(); i += kHitStride) sums.hits += rays[i].is_hit ? 1 : 0;
  sums.known = std::count(is_known.begin(), is_known.end(), true);
  return sums;
}

ConsistencyValue mean_of(ConsistencyFigure figure, double sum, std::int64_t count) {
  ConsistencyValue result{figure};
  result.measured = static_cast<double>(count);
  if (count > 0) result.value = sum / result.measured;
  return result;
}

}  // namespace

ConsistencyValue rays_through_walls(const PlacedAll& all, const ConsistencyOptions& options) {
  const NearAsrs walls(all, &PlacedEvidence::solid, 0.0);
  std::int64_t met = 0;
  std::int64_t through = 0;
  for (const RaysAtWalls& rays :
       results_of<RaysAtWalls>(all.size(), options.jobs,
                               [&](std::size_t i) { return rays_of(all[i], walls, options); })) {
    met += rays.met;
    through += rays.through;
  }
  return mean_of(ConsistencyFigure::rays_through_walls, static_cast<double>(through), met);
}

std::vector<VisitAgreement> judge_visits(const PlacedAll& all, const ConsistencyOptions& options) {
  const NearAsrs seen(all, &PlacedEvidence::seen, options.deep_m);
  return results_of<VisitAgreement>(
      all.size(), options.jobs, [&](std::size_t i) { return judge_visit(all[i], seen, options); });
}

HitFigures judge_hits(const PlacedAll& all, const ConsistencyOptions& options) {
  VisitAgreement sums;
  for (const VisitAgreement& visit : judge_visits(all, options)) {
    sums.seen += visit.seen;
    sums.in_free_space += visit.in_free_space;
    sums.compared += visit.compared;
    sums.apart_m += visit.apart_m;
  }
  return {mean_of(ConsistencyFigure::hits_in_free_space, static_cast<double>(sums.in_free_space),
                  sums.seen),
          mean_of(ConsistencyFigure::doubled_walls, sums.apart_m, sums.compared)};
}

}  // namespace roomatlas
