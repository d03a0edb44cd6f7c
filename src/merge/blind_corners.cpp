// SPDX-License-Identifier: GPL-3.0-or-later
#include "blind_corners.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "ring_edges.hpp"
#include "wall_lines.hpp"

namespace roomatlas {
namespace {

constexpr double kAtJambM = 0.15;         // ends of a threshold are this near to its jambs; larger
                                          // leaves corners beside doors cut off
constexpr double kRightAngleSine = 0.99;  // 8 degrees off at most

/// Whether an edge runs from jamb to jamb.
bool is_threshold(const Point2& a, const Point2& b, const std::vector<Door>& doors) {
  const auto are_at = [&](const Point2& first, const Point2& second) {
    return (a - first).norm() < kAtJambM && (b - second).norm() < kAtJambM;
  };
  return std::any_of(doors.begin(), doors.end(), [&](const Door& door) {
    return are_at(door.jambs.a, door.jambs.b) || are_at(door.jambs.b, door.jambs.a);
  });
}

/// Where the lines of the edges before and after an edge meet, if that is a corner cut off by it.
std::optional<Point2> corner_cut_off(const Ring& ring, std::size_t edge,
                                     const std::vector<Door>& doors,
                                     const std::vector<double>& directions_rad,
                                     const RegularWallOptions& options) {
  const std::size_t count = ring.size();
  const Point2& before = ring[(edge + count - 1) % count];
  const Point2& from = ring[edge];
  const Point2& to = ring[(edge + 1) % count];
  const Point2& after = ring[(edge + 2) % count];
  if ((to - from).norm() > options.blind_corner_m) return std::nullopt;
  const auto first = regular_edge(before, from, directions_rad, options);
  const auto second = regular_edge(to, after, directions_rad, options);
  if (!first || !second || is_threshold(before, from, doors) || is_threshold(to, after, doors)) {
    return std::nullopt;
  }
  const double turn = cross(first->line.along, second->line.along);
  if (turn < kRightAngleSine) return std::nullopt;  // no right angle to the left: floor inside it
  const double on_m = cross(to - from, second->line.along) / turn;
  const Point2 corner = from + on_m * first->line.along;
  const bool is_beyond = on_m > 0.0 && second->line.along.dot(to - corner) > 0.0;
  const bool is_near =
      on_m <= options.blind_corner_m && (to - corner).norm() <= options.blind_corner_m;
  return is_beyond && is_near ? std::optional<Point2>(corner) : std::nullopt;
}

}  // namespace

Ring with_closed_corners(const Ring& ring, const std::vector<Door>& doors,
                         const std::vector<double>& directions_rad,
                         const RegularWallOptions& options) {
  if (options.blind_corner_m <= 0.0 || ring.size() < 4) return ring;
  std::vector<std::optional<Point2>> corners(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    corners[i] = corner_cut_off(ring, i, doors, directions_rad, options);
  }
  Ring closed;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t before = (i + ring.size() - 1) % ring.size();
    if (corners[i]) {
      closed.push_back(*corners[i]);
    } else if (!corners[before]) {
      closed.push_back(ring[i]);
    }
  }
  return closed;
}

}  // namespace roomatlas
