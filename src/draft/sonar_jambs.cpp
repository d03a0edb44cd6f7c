// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_jambs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace roomatlas {
namespace {

constexpr double kJambStep_m = 0.02;  // between jambs that are tried
constexpr double kNarrowest_m = 0.3;  // half of it is on each side of the middle
constexpr double kWidest_m = 2.0;
constexpr double kFarthest_m = 2.5;  // sonar to wall; a cone is wider than a door there
constexpr double kSigma_m = 0.03;    // of an echo's range: noise, path and the wall's own place
constexpr double kOutlier = 0.05;    // share of echoes from something else
constexpr double kThrough_m = 0.15;  // what is heard this far behind the wall is heard through it
constexpr std::size_t kFewestEchoes = 20;

/// An echo in the frame of a wall: along it, and off it on the side of the sonar.
struct Heard {
  double along_m = 0.0;
  double off_m = 0.0;
  double axis_rad = 0.0;  ///< of the beam, from the way straight at the wall
  double range_m = 0.0;
  bool is_hit = false;
};

std::vector<Heard> heard_at(const WallFace& face, double middle_m,
                            const BuildingEvidence& evidence) {
  std::vector<Heard> heard;
  const Point2 normal = face.normal();
  const Point2 along = face.along();
  for (const Echo& echo : evidence.echoes) {
    const Point2 from = echo.building_from_beam.position();
    const double off_m = from.dot(normal) - face.offset_m;
    if (off_m < 0.1 || off_m > kFarthest_m) continue;
    const double along_m = from.dot(along);
    if (std::abs(along_m - middle_m) > kWidest_m) continue;
    // Positive turns towards larger positions along the face.
    const double axis_rad =
        -wrap_angle(echo.building_from_beam.theta_rad - (face.normal_rad + kPi));
    if (std::abs(axis_rad) > evidence.sonar_half_cone_rad) continue;
    heard.push_back({along_m, off_m, axis_rad, echo.range_m, echo.is_hit});
  }
  return heard;
}

/// The nearest point of a wall in a cone, where the wall runs from `low_m` to `high_m`.
double nearest_m(const Heard& echo, double low_m, double high_m, double half_cone_rad) {
  const double from_m = echo.along_m + echo.off_m * std::tan(echo.axis_rad - half_cone_rad);
  const double to_m = echo.along_m + echo.off_m * std::tan(echo.axis_rad + half_cone_rad);
  const double first_m = std::max(low_m, from_m);
  const double last_m = std::min(high_m, to_m);
  if (first_m > last_m) return std::numeric_limits<double>::infinity();
  const double at_m = std::clamp(echo.along_m, first_m, last_m);
  return std::hypot(at_m - echo.along_m, echo.off_m);
}

/// How unlikely an echo is, when the nearest point of the wall is so far away.
double surprise(const Heard& echo, double expected_m) {
  const double wall_range_m = echo.off_m / std::cos(echo.axis_rad);
  double likelihood = kOutlier;
  if (std::isinf(expected_m)) {
    const bool is_through = !echo.is_hit || echo.range_m > wall_range_m + kThrough_m;
    likelihood += is_through ? 1.0 - kOutlier : 0.0;
  } else if (echo.is_hit) {
    const double off = (echo.range_m - expected_m) / kSigma_m;
    likelihood += (1.0 - kOutlier) * std::exp(-0.5 * off * off);
  }
  return -std::log(likelihood);
}

/// The wall on one side of an opening, if its jamb were here.
struct Side {
  double jamb_m = 0.0;
  std::vector<double> distance_m;  ///< to the nearest point in the cone, by echo
  std::vector<double> surprise;    ///< if that is what was heard
};

std::vector<Side> sides_of(const std::vector<Heard>& heard, double middle_m, double sign,
                           double half_cone_rad) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  std::vector<Side> sides;
  for (double off_m = kNarrowest_m / 2.0; off_m <= kWidest_m / 2.0; off_m += kJambStep_m) {
    Side& side = sides.emplace_back();
    side.jamb_m = middle_m + sign * off_m;
    for (const Heard& echo : heard) {
      const double distance_m = sign < 0.0 ? nearest_m(echo, -kInfinite, side.jamb_m, half_cone_rad)
                                           : nearest_m(echo, side.jamb_m, kInfinite, half_cone_rad);
      side.distance_m.push_back(distance_m);
      side.surprise.push_back(surprise(echo, distance_m));
    }
  }
  return sides;
}

}  // namespace

std::optional<Interval> sonar_jambs(const WallFace& face, double middle_m,
                                    const BuildingEvidence& evidence) {
  const std::vector<Heard> heard = heard_at(face, middle_m, evidence);
  if (heard.size() < kFewestEchoes) return std::nullopt;
  const std::vector<Side> low = sides_of(heard, middle_m, -1.0, evidence.sonar_half_cone_rad);
  const std::vector<Side> high = sides_of(heard, middle_m, 1.0, evidence.sonar_half_cone_rad);
  double least = std::numeric_limits<double>::infinity();
  Interval best;
  for (const Side& a : low) {
    for (const Side& b : high) {
      double sum = 0.0;  // the nearest of two walls is what is heard
      for (std::size_t k = 0; k < heard.size(); ++k) {
        sum += a.distance_m[k] <= b.distance_m[k] ? a.surprise[k] : b.surprise[k];
      }
      if (sum >= least) continue;
      least = sum;
      best = {a.jamb_m, b.jamb_m};
    }
  }
  return best;
}

}  // namespace roomatlas
