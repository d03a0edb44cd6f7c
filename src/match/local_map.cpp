// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/match/local_map.hpp"

#include <algorithm>
#include <limits>

#include "roomatlas/grid/himm_grid.hpp"

namespace roomatlas {
namespace {

constexpr double kMaxHits = 40.0;     // beyond it older hits fade ...
constexpr double kFade = 0.9;         // ... by this, so that the mean keeps following
constexpr double kClearNormal = 0.5;  // of the hits' normals, this share points one way

}  // namespace

void LocalMap::raise(const Cell& cell, int half_steps) {
  std::int8_t& certainty = cells_.edit(cell).certainty;
  certainty = static_cast<std::int8_t>(
      std::clamp(certainty + half_steps, HimmGrid::kMinHalfSteps, HimmGrid::kMaxHalfSteps));
}

void LocalMap::add_free(const Point2& from, const Point2& to) {
  const auto pass = [&](const Cell& cell) {
    raise(cell, HimmGrid::kFreeHalfSteps);
    return true;
  };
  for_each_cell_on_line(frame_.cell_of(from), frame_.cell_of(to), pass, 2);
}

void LocalMap::add_hit(const Point2& position, const Point2& normal) {
  const Cell hit = frame_.cell_of(position);
  for_each_cell({{hit.x - 1, hit.y - 1}, {hit.x + 2, hit.y + 2}}, [&](const Cell& cell) {
    raise(cell, cell == hit ? HimmGrid::kHitHalfSteps : HimmGrid::kNeighborHalfSteps);
  });
  add({position, normal, 1.0});
}

void LocalMap::add(const Face& seen) {
  std::uint32_t* slot = &cells_.edit(frame_.cell_of(seen.position)).face;
  if (*slot != 0 && faces_[*slot - 1U].normal_sum.dot(seen.normal) < 0.0) {
    slot = &faces_[*slot - 1U].other;  // the wall's other side
  }
  if (*slot == 0) {
    if (faces_.size() == std::numeric_limits<std::uint32_t>::max()) return;
    *slot = static_cast<std::uint32_t>(faces_.size() + 1);
    faces_.emplace_back();  // `slot` may point into `faces_`: it is not used any more
    faces_.back().mean = seen;
    faces_.back().normal_sum = seen.hits * seen.normal;
    return;
  }
  StoredFace& face = faces_[*slot - 1U];
  if (face.mean.hits > kMaxHits) {
    face.mean.hits *= kFade;
    face.normal_sum *= kFade;
  }
  face.mean.hits += seen.hits;
  face.mean.position += seen.hits * (seen.position - face.mean.position) / face.mean.hits;
  face.normal_sum += seen.hits * seen.normal;
  const double length = face.normal_sum.norm();
  const bool is_clear = length > kClearNormal * face.mean.hits;
  face.mean.normal = is_clear ? Point2(face.normal_sum / length) : Point2::Zero();
}

void LocalMap::add(const Scan& scan, const Pose2& map_from_robot) {
  const PointTransform place(map_from_robot);
  const PointTransform turn({0.0, 0.0, map_from_robot.theta_rad});
  Point2 sensor = place * scan.sensor;
  auto further = scan.further.begin();
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    for (; further != scan.further.end() && further->first_point <= i; ++further) {
      sensor = place * further->sensor;
    }
    add_free(sensor, place * scan.points[i].position);
  }
  for (const ScanPoint& point : scan.points) {
    if (point.is_hit) add_hit(place * point.position, turn * point.normal);
  }
}

std::vector<Face> LocalMap::faces(double min_hits) const {
  std::vector<Face> found;
  cells_.for_each([&](const Cell&, const LocalCell& cell) {
    for (std::uint32_t i = cell.face; i != 0; i = faces_[i - 1U].other) {
      if (faces_[i - 1U].mean.hits >= min_hits) found.push_back(faces_[i - 1U].mean);
    }
  });
  return found;
}

}  // namespace roomatlas
