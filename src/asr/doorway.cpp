// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/asr/doorway.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace roomatlas {
namespace {

constexpr double kStepM = 0.05;       // sampling along a chord: half a cell
constexpr double kMaxReachM = 2.0;    // half-chords are not followed farther
constexpr int kAngles = 11;           // chord directions, within ...
constexpr double kMaxSkewDeg = 40.0;  // ... this angle of the perpendicular to the motion
constexpr double kMinJambM = 0.15;    // a jamb nearer than this would touch the robot
constexpr double kSideReachM = 1.5;   // how wide the space ahead and behind is measured
constexpr double kSideFromM = 0.4;    // off the chord: nearer is still inside a thick wall ...
constexpr double kSideToM = 0.85;     // ... farther (0.8, and a rounding) is past a narrow lobby
constexpr double kSideEveryM = 0.1;   // a cell

/// Distance from `from` along `along` to the first obstacle; nothing within `reach_m`.
std::optional<double> first_obstacle(const HimmGrid& grid, const Point2& from, const Point2& along,
                                     double reach_m, double occupied_value) {
  for (double at_m = 2.0 * kStepM; at_m <= reach_m; at_m += kStepM) {
    const Cell cell = grid.frame().cell_of(from + at_m * along);
    if (grid.value(cell) >= occupied_value) return at_m;
  }
  return std::nullopt;
}

/// A chord through a point of the path, between two obstacles.
struct Chord {
  double heading_rad = 0.0;  // perpendicular to the chord, along the motion
  double left_m = 0.0;
  double right_m = 0.0;
  [[nodiscard]] double width_m() const { return left_m + right_m; }
};

/// Chords are measured in steps, so that several are equally narrow: of these, the one across the
/// motion.
std::optional<Chord> narrowest_chord(const HimmGrid& grid, const Pose2& at,
                                     const DoorwayOptions& options) {
  std::vector<Chord> narrowest;
  for (int i = 0; i < kAngles; ++i) {
    const double skew = radians(kMaxSkewDeg) * (2.0 * i / (kAngles - 1) - 1.0);
    const double heading = at.theta_rad + skew;
    const Point2 left = direction(heading + kPi / 2.0);
    const auto to_left =
        first_obstacle(grid, at.position(), left, kMaxReachM, options.occupied_value);
    const auto to_right =
        first_obstacle(grid, at.position(), -left, kMaxReachM, options.occupied_value);
    if (!to_left || !to_right) continue;
    const Chord chord{heading, *to_left, *to_right};
    const double wider_m = narrowest.empty() ? 0.0 : chord.width_m() - narrowest.front().width_m();
    if (wider_m > kStepM / 2.0) continue;
    if (wider_m < -kStepM / 2.0) narrowest.clear();
    narrowest.push_back(chord);
  }
  if (narrowest.empty()) return std::nullopt;
  return *std::min_element(narrowest.begin(), narrowest.end(), [&](const Chord& a, const Chord& b) {
    return std::abs(wrap_angle(a.heading_rad - at.theta_rad)) <
           std::abs(wrap_angle(b.heading_rad - at.theta_rad));
  });
}

/// The greatest width of the space 0.4 to 0.8 m along `along` from the chord's mid-point.
double width_beside(const HimmGrid& grid, const Point2& middle, const Point2& along,
                    double occupied_value) {
  const Point2 left(-along.y(), along.x());
  double widest = 0.0;
  for (double off_m = kSideFromM; off_m < kSideToM; off_m += kSideEveryM) {
    const Point2 at = middle + off_m * along;
    const double width =
        first_obstacle(grid, at, left, kSideReachM, occupied_value).value_or(kSideReachM) +
        first_obstacle(grid, at, -left, kSideReachM, occupied_value).value_or(kSideReachM);
    widest = std::max(widest, width);
  }
  return widest;
}

}  // namespace

std::optional<Doorway> find_doorway(const HimmGrid& grid, const Pose2& grid_from_path,
                                    const DoorwayOptions& options) {
  const std::optional<Chord> chord = narrowest_chord(grid, grid_from_path, options);
  if (!chord) return std::nullopt;
  const auto [nearer, farther] = std::minmax(chord->left_m, chord->right_m);
  if (chord->width_m() < options.min_width_m || chord->width_m() > options.max_width_m ||
      nearer < kMinJambM || farther > options.max_jamb_m) {
    return std::nullopt;
  }
  const Point2 along = direction(chord->heading_rad);
  const Point2 left(-along.y(), along.x());
  const Point2 middle = grid_from_path.position() + (chord->left_m - chord->right_m) / 2.0 * left;
  const double needed_m = chord->width_m() + options.widening_m;
  if (width_beside(grid, middle, along, options.occupied_value) <= needed_m ||
      width_beside(grid, middle, -along, options.occupied_value) <= needed_m) {
    return std::nullopt;
  }
  // A hit raises its neighbours too, so that an obstacle shows one cell before its surface.
  const double width_m = chord->width_m() + 2.0 * grid.frame().cell_m;
  const Point2 half = width_m / 2.0 * left;
  return Doorway{{middle.x(), middle.y(), wrap_angle(chord->heading_rad)},
                 width_m,
                 {middle + half, middle - half}};
}

}  // namespace roomatlas
