// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "roomatlas/sonar/wall_segments.hpp"

namespace roomatlas {
namespace {

constexpr double kMaxOffEdgeRad = radians(80.0);  // a wall along the cone's edge is not heard
constexpr double kLeastCosOff = 0.17;             // that angle's: flatter, residuals would explode
constexpr double kHoldLine = 1e-9;                // of equations that returns leave open
constexpr std::size_t kFewest = 3;                // returns of a line: two fit any
constexpr int kMaxSteps = 8;                      // an end; a fit that has not settled is used
constexpr double kTooFar = 1.0;                   // of a step, rad or m: the fit has lost the wall
constexpr double kSettled = 1e-6;                 // of a step, rad and m

/// How far off its axis a sonar hears a wall: the wall's normal, or the edge of the cone that is
/// nearest to it.
double heard_off_axis(const ConeReturn& from, double half_cone_rad, const ConeLine& line) {
  const double off = wrap_angle(line.normal_rad - from.axis_rad);
  return std::clamp(off, -half_cone_rad, half_cone_rad);
}

void turn_to(double normal_rad, ConeLine& line) {
  line.normal_rad = normal_rad;
  line.normal = direction(normal_rad);
}

/// The line through points by total least squares, its normal away from `behind`.
ConeLine line_through(std::span<const ConeReturn> returns, const Point2& middle,
                      const Point2& behind) {
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const ConeReturn& one : returns) {
    const Point2 d = one.sonar + one.range_m * one.axis - middle;
    xx += d.x() * d.x();
    xy += d.x() * d.y();
    yy += d.y() * d.y();
  }
  ConeLine line{wrap_angle(0.5 * std::atan2(2.0 * xy, xx - yy) + kPi / 2.0)};
  if (line.normal.dot(middle - behind) < 0.0) turn_to(wrap_angle(line.normal_rad + kPi), line);
  line.offset_m = line.normal.dot(middle);
  return line;
}

/// Sums of one Gauss-Newton step about a pivot point: of normal angle and offset at the pivot.
struct Equations {
  double h00 = kHoldLine;
  double h01 = 0.0;
  double h11 = kHoldLine;
  double g0 = 0.0;
  double g1 = 0.0;
  double squares = 0.0;
};

/// The residual of a return is (normal . p - offset) / cos(off), p the point of the echo and
/// `off` the angle between echo and normal; along the perpendicular p turns with the normal, and
/// the derivative by the angle is that of the sonar's own distance.
/// @param half_cone of unit length: cosine and sine of its angle
Equations equations_at(std::span<const ConeReturn> returns, const Point2& half_cone,
                       const ConeLine& line, const Point2& pivot) {
  const Point2& normal = line.normal;
  const Point2 tangent(-normal.y(), normal.x());
  const double cos_half = half_cone.x();
  const double sin_half = half_cone.y();
  const double pivot_along = normal.dot(pivot);
  // Of echoes along the normal; mostly 1 to the last bit, and then nothing has to be divided by it.
  const double cos_inside = normal.dot(normal);
  const bool is_unit = cos_inside == 1.0;
  const double j1_inside = -1.0 / cos_inside;
  Equations sums;
  for (const ConeReturn& one : returns) {
    const Point2& axis = one.axis;
    const double along = normal.dot(axis);
    const double across = tangent.dot(axis);  // sine of axis off normal
    const bool inside = along > 0.0 && std::abs(across) <= sin_half;
    const Point2 arm = one.sonar - pivot;
    double residual = 0.0;
    double j0 = 0.0;
    double j1 = j1_inside;
    if (inside) {
      residual = normal.dot(Point2(arm + one.range_m * normal)) + pivot_along - line.offset_m;
      j0 = tangent.dot(arm);
      if (!is_unit) {
        residual /= cos_inside;
        j0 /= cos_inside;
      }
    } else {  // the edge of the cone towards the normal
      const double turn = across > 0.0 ? -sin_half : sin_half;
      const Point2 echo(cos_half * axis.x() - turn * axis.y(),
                        turn * axis.x() + cos_half * axis.y());
      const double cos_off = std::max(normal.dot(echo), kLeastCosOff);
      const Point2 point = arm + one.range_m * echo;
      residual = (normal.dot(point) + pivot_along - line.offset_m) / cos_off;
      j0 = tangent.dot(point) / cos_off;
      j1 = -1.0 / cos_off;
    }
    sums.h00 += j0 * j0;
    sums.h01 += j0 * j1;
    sums.h11 += j1 * j1;
    sums.g0 += j0 * residual;
    sums.g1 += j1 * residual;
    sums.squares += residual * residual;
  }
  return sums;
}

}  // namespace

std::optional<double> range_to_line(const ConeReturn& from, double half_cone_rad,
                                    const ConeLine& line) {
  const double distance_m = line.offset_m - line.normal.dot(from.sonar);
  const double off = std::abs(wrap_angle(from.axis_rad - line.normal_rad));
  const double off_edge = std::max(0.0, off - half_cone_rad);
  if (distance_m <= 0.0 || off_edge > kMaxOffEdgeRad) return std::nullopt;
  return distance_m / std::cos(off_edge);
}

Point2 foot_of(const ConeReturn& from, double half_cone_rad, const ConeLine& line) {
  return from.sonar +
         from.range_m * direction(from.axis_rad + heard_off_axis(from, half_cone_rad, line));
}

std::optional<ConeLine> fit_line(std::span<const ConeReturn> returns, double half_cone_rad) {
  if (returns.size() < kFewest) return std::nullopt;
  Point2 middle = Point2::Zero();
  Point2 behind = Point2::Zero();
  for (const ConeReturn& one : returns) {
    middle += one.sonar + one.range_m * one.axis;
    behind += one.sonar;
  }
  middle /= static_cast<double>(returns.size());
  behind /= static_cast<double>(returns.size());
  ConeLine line = line_through(returns, middle, behind);
  const Point2 half_cone = direction(half_cone_rad);
  for (int step = 0; step < kMaxSteps; ++step) {
    const Equations sums = equations_at(returns, half_cone, line, middle);
    line.sigma_m = std::sqrt(sums.squares / static_cast<double>(returns.size()));
    const double determinant = sums.h00 * sums.h11 - sums.h01 * sums.h01;
    const double turn = -(sums.h11 * sums.g0 - sums.h01 * sums.g1) / determinant;
    const double shift = -(sums.h00 * sums.g1 - sums.h01 * sums.g0) / determinant;
    if (!(std::abs(turn) < kTooFar && std::abs(shift) < kTooFar)) return std::nullopt;
    // the offset moves with the turn, since the line turns about the pivot
    const double at_pivot = line.offset_m - line.normal.dot(middle) + shift;
    turn_to(wrap_angle(line.normal_rad + turn), line);
    line.offset_m = at_pivot + line.normal.dot(middle);
    if (std::abs(turn) < kSettled && std::abs(shift) < kSettled) break;
  }
  return line;
}

}  // namespace roomatlas
