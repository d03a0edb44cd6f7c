// SPDX-License-Identifier: GPL-3.0-or-later
#include "corners.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "roomatlas/polyline/simplify.hpp"

namespace roomatlas {
namespace {

/// The ring without vertices that matter less than the tolerance. Starts at the vertex farthest
/// from the middle, which is a corner.
Ring simplified(const Ring& ring, double tolerance_m) {
  if (ring.size() < 4) return ring;
  Point2 middle = Point2::Zero();
  for (const Point2& point : ring) middle += point / static_cast<double>(ring.size());
  const auto farthest =
      std::max_element(ring.begin(), ring.end(), [&](const Point2& a, const Point2& b) {
        return (a - middle).squaredNorm() < (b - middle).squaredNorm();
      });
  Polyline open(farthest, ring.end());
  open.insert(open.end(), ring.begin(), farthest + 1);
  Ring kept;
  for (const std::size_t i : douglas_peucker(open, tolerance_m)) kept.push_back(open[i]);
  kept.pop_back();
  return kept;
}

double heading(const Point2& from, const Point2& to) {
  return std::atan2(to.y() - from.y(), to.x() - from.x());
}

}  // namespace

std::vector<Corner> corners_of(const std::vector<Ring>& rings, const CornerOptions& options) {
  std::vector<Corner> corners;
  for (const Ring& full : rings) {
    const Ring ring = simplified(full, options.simplify_m);
    const std::size_t count = ring.size();
    if (count < 3) continue;
    for (std::size_t i = 0; i < count; ++i) {
      const Corner corner{ring[i], heading(ring[(i + count - 1) % count], ring[i]),
                          heading(ring[i], ring[(i + 1) % count])};
      if (std::abs(wrap_angle(corner.out_rad - corner.in_rad)) >= options.min_turn_rad) {
        corners.push_back(corner);
      }
    }
  }
  return corners;
}

bool same_directions(const Corner& a, const Corner& b, double gate_rad) {
  return std::abs(wrap_angle(a.in_rad - b.in_rad)) <= gate_rad &&
         std::abs(wrap_angle(a.out_rad - b.out_rad)) <= gate_rad;
}

std::vector<CornerMatch> match_corners(const std::vector<Corner>& ours,
                                       const std::vector<Corner>& theirs, double gate_m) {
  std::vector<CornerMatch> candidates;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    for (std::size_t j = 0; j < theirs.size(); ++j) {
      const double distance_m = (ours[i].point - theirs[j].point).norm();
      if (distance_m > gate_m || !same_directions(ours[i], theirs[j], kPi / 2.0)) continue;
      candidates.push_back({i, j, distance_m});
    }
  }
  std::sort(candidates.begin(), candidates.end(), [](const CornerMatch& a, const CornerMatch& b) {
    return std::tie(a.distance_m, a.ours, a.theirs) < std::tie(b.distance_m, b.ours, b.theirs);
  });
  std::vector<bool> ours_taken(ours.size(), false);
  std::vector<bool> theirs_taken(theirs.size(), false);
  std::erase_if(candidates, [&](const CornerMatch& match) {
    if (ours_taken[match.ours] || theirs_taken[match.theirs]) return true;
    ours_taken[match.ours] = theirs_taken[match.theirs] = true;
    return false;
  });
  return candidates;
}

}  // namespace roomatlas
