// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "roomatlas/evaluate/asr_evidence.hpp"

namespace roomatlas {
namespace {

constexpr int kMarginCells = 4;        ///< around everything seen, so that hits have room around
constexpr int kNormalReach = 3;        ///< cells around a hit that tell the surface's direction
constexpr int kNormalPoints = 4;       ///< at least
constexpr double kStraightness = 0.1;  ///< largest share of the spread across the surface

}  // namespace

SeenSpace::SeenSpace(const std::vector<MeasuredRay>& rays, double cell_m) : cell_m_(cell_m) {
  for (const MeasuredRay& ray : rays) {
    box_.extend(ray.segment.a);
    box_.extend(ray.segment.b);
  }
  if (box_.empty()) return;
  box_.min.array() -= kMarginCells * cell_m;
  box_.max.array() += kMarginCells * cell_m;
  columns_ = static_cast<int>(std::floor(box_.size().x() / cell_m)) + 1;
  rows_ = static_cast<int>(std::floor(box_.size().y() / cell_m)) + 1;
  const auto cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  free_.assign(cells, 0);
  hit_index_.assign(cells, -1);
  near_hit_.assign(cells, false);
  add_hits(rays);
  add_free(rays);
  mark_near_hits();
  find_normals();
}

SeenSpace::CellIndex SeenSpace::cell_of(const Point2& point) const {
  return {static_cast<int>(std::floor((point.x() - box_.min.x()) / cell_m_)),
          static_cast<int>(std::floor((point.y() - box_.min.y()) / cell_m_))};
}

std::optional<std::size_t> SeenSpace::slot(const CellIndex& cell) const {
  if (cell.column < 0 || cell.column >= columns_ || cell.row < 0 || cell.row >= rows_) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(cell.column);
}

void SeenSpace::add_hits(const std::vector<MeasuredRay>& rays) {
  for (const MeasuredRay& ray : rays) {
    if (!ray.is_hit) continue;
    std::int32_t& index = hit_index_[*slot(cell_of(ray.segment.b))];
    if (index < 0) {
      index = static_cast<std::int32_t>(hits_.size());
      hits_.emplace_back();
    }
    HitCell& hit = hits_[static_cast<std::size_t>(index)];
    hit.mean += ray.segment.b;
    hit.seen_along += (ray.segment.b - ray.segment.a).normalized();
    ++hit.hits;
  }
  for (HitCell& hit : hits_) hit.mean /= hit.hits;
}

void SeenSpace::mark_near_hits() {
  for (const HitCell& hit : hits_) {
    const CellIndex at = cell_of(hit.mean);
    for (int row = at.row - kMarginCells; row <= at.row + kMarginCells; ++row) {
      for (int column = at.column - kMarginCells; column <= at.column + kMarginCells; ++column) {
        if (const auto here = slot({column, row})) near_hit_[*here] = true;
      }
    }
  }
}

/// A ray frees its cells up to two cells before its end, each once.
void SeenSpace::add_free(const std::vector<MeasuredRay>& rays) {
  for (const MeasuredRay& ray : rays) {
    const Point2 along = ray.segment.b - ray.segment.a;
    const double length_m = along.norm() - (ray.is_hit ? 2.0 * cell_m_ : 0.0);
    if (!(length_m > 0.0)) continue;
    const Point2 unit = along.normalized();
    std::optional<std::size_t> former;
    for (double at_m = 0.0; at_m < length_m; at_m += 0.5 * cell_m_) {
      const auto here = slot(cell_of(ray.segment.a + at_m * unit));
      if (!here || here == former) continue;
      former = here;
      if (free_[*here] < std::numeric_limits<std::uint8_t>::max()) ++free_[*here];
    }
  }
}

template <typename Visit>
void SeenSpace::for_hits_near(const Point2& point, int reach, Visit visit) const {
  const CellIndex at = cell_of(point);
  for (int row = at.row - reach; row <= at.row + reach; ++row) {
    for (int column = at.column - reach; column <= at.column + reach; ++column) {
      const auto here = slot({column, row});
      if (here && hit_index_[*here] >= 0) visit(hits_[static_cast<std::size_t>(hit_index_[*here])]);
    }
  }
}

/// The direction with the least spread of the hits around, where they lie along a line.
void SeenSpace::find_normals() {
  for (HitCell& hit : hits_) {
    Point2 mean = Point2::Zero();
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    int count = 0;
    for_hits_near(hit.mean, kNormalReach, [&](const HitCell& other) {
      mean += other.mean;
      squares += other.mean * other.mean.transpose();
      ++count;
    });
    if (count < kNormalPoints) continue;
    mean /= count;
    const Eigen::Matrix2d spread = squares / count - mean * mean.transpose();
    const double angle =
        0.5 * std::atan2(2.0 * spread(0, 1), spread(0, 0) - spread(1, 1));  // along the surface
    const Point2 normal = direction(angle + kPi / 2.0);
    const double across = normal.dot(spread * normal);
    if (across <= kStraightness * spread.trace()) hit.normal = normal;
  }
}

int SeenSpace::free_rays(const Point2& point) const {
  const auto here = slot(cell_of(point));
  return here ? free_[*here] : 0;
}

NearHit SeenSpace::nearest_hit(const Point2& point, const Point2& along, double reach_m) const {
  NearHit nearest;
  const int reach = std::min(static_cast<int>(std::ceil(reach_m / cell_m_)), kMarginCells);
  const auto here = slot(cell_of(point));
  if (!here || !near_hit_[*here]) return nearest;
  double straight_m = reach_m;
  for_hits_near(point, reach, [&](const HitCell& hit) {
    const double away_m = (hit.mean - point).norm();
    if (away_m > reach_m) return;
    nearest.is_near = true;
    if (!hit.normal || away_m > straight_m) return;
    if (hit.normal->dot(along) * hit.normal->dot(hit.seen_along) <= 0.0) return;
    straight_m = away_m;
    nearest.across_m = std::abs(hit.normal->dot(hit.mean - point));
  });
  return nearest;
}

}  // namespace roomatlas
