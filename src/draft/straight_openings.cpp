// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/straight_openings.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace roomatlas {
namespace {

constexpr double kBeyond_m = 0.6;  // of wall beyond a jamb that is its wall's end

double turn_from(const WallFace& face, const Segment2& line) {
  const Point2 along = (line.b - line.a).normalized();
  return std::asin(std::min(1.0, std::abs(face.normal().dot(along))));
}

double off_m(const WallFace& face, const Point2& at) {
  return std::abs(at.dot(face.normal()) - face.offset_m);
}

/// Whether a face was seen beside a place, away from where `to` is.
bool ends_at(const WallFace& face, const Point2& at, const Point2& to, double within_m) {
  if (off_m(face, at) > within_m) return false;
  const double at_m = at.dot(face.along());
  const double away = to.dot(face.along()) > at_m ? -1.0 : 1.0;
  const double low_m = std::min(at_m, at_m + away * kBeyond_m);
  return std::any_of(face.seen.begin(), face.seen.end(), [&](const Interval& seen) {
    const double common_m = std::min(seen.high_m, low_m + kBeyond_m) - std::max(seen.low_m, low_m);
    return common_m > kBeyond_m / 3.0;
  });
}

Point2 onto(const WallFace& face, const Point2& at) { return face.at(at.dot(face.along())); }

}  // namespace

Door straightened(const Door& opening, const Walls& walls, const StraightOpeningOptions& options) {
  const Segment2& jambs = opening.jambs;
  std::optional<Segment2> best;
  double most_m = options.least_support_m;
  for (const WallFace& face : walls.faces) {
    if (face.is_furniture) continue;
    const double turn_rad = turn_from(face, jambs);
    const bool is_along = turn_rad < radians(options.least_turn_deg);
    const bool is_of_wall = face.support_m() > opening.width_m / 2.0;  // a leaf is shorter
    if (is_along && is_of_wall && off_m(face, jambs.a) < options.beside_m) return opening;
    if (is_along || !face.is_regular || turn_rad > radians(options.most_turn_deg)) continue;
    const bool at_a = ends_at(face, jambs.a, jambs.b, options.beside_m);
    const bool at_b = ends_at(face, jambs.b, jambs.a, options.beside_m);
    if (!at_a && !at_b) continue;
    const Segment2 line{onto(face, jambs.a), onto(face, jambs.b)};
    const double moved_m = std::max((line.a - jambs.a).norm(), (line.b - jambs.b).norm());
    if (moved_m > options.most_aside_m || face.prominence_m <= most_m) continue;
    most_m = face.prominence_m;
    best = line;
  }
  if (!best) return opening;
  Door straight = opening;
  static_cast<Doorway&>(straight) = doorway_between(*best);
  return straight;
}

}  // namespace roomatlas
