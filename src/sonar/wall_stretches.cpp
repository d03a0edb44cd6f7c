// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_stretches.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr double kGateM = 0.15;     // a return farther off comes from something else
constexpr double kBesideM = 0.1;    // beyond the ends of the stretch of wall that was seen
constexpr double kMaxOffRad = 1.0;  // of a wall's normal from a sonar's axis: flatter ones send no
                                    // echo back

std::vector<WallStretch> stretches_of(std::span<const SeenWall> walls,
                                      std::span<const Pose2> map_from_node) {
  std::vector<WallStretch> result;
  result.reserve(walls.size());
  for (const SeenWall& seen : walls) {
    const Pose2& node = map_from_node[seen.node];
    WallStretch wall;
    wall.middle = node * seen.middle_node;
    wall.line = {wrap_angle(node.theta_rad + seen.normal_rad)};
    wall.along = {-wall.line.normal.y(), wall.line.normal.x()};
    wall.line.offset_m = wall.line.normal.dot(wall.middle);
    wall.half_length_m = seen.length_m / 2.0;
    result.push_back(wall);
  }
  return result;
}

void add_squares(const WallStretch& wall, std::uint32_t item, double tile_m,
                 std::vector<SquareIndex::Entry>& entries) {
  const int steps = static_cast<int>(std::ceil(2.0 * wall.half_length_m / (tile_m / 2.0))) + 1;
  const std::size_t first = entries.size();
  for (int i = 0; i <= steps; ++i) {
    const double at_m = wall.half_length_m * (2.0 * i / steps - 1.0);
    const Square square = square_of(wall.middle + at_m * wall.along, tile_m);
    const bool is_there =
        std::any_of(entries.begin() + static_cast<std::ptrdiff_t>(first), entries.end(),
                    [&](const SquareIndex::Entry& entry) { return entry.square == square; });
    if (!is_there) entries.push_back({square, item});
  }
}

}  // namespace

WallStretches::WallStretches(std::span<const SeenWall> walls, std::span<const Pose2> map_from_node)
    : stretches_(stretches_of(walls, map_from_node)), near_(squares_of(stretches_)) {}

std::vector<SquareIndex::Entry> WallStretches::squares_of(
    const std::vector<WallStretch>& stretches) {
  std::vector<SquareIndex::Entry> entries;
  for (std::uint32_t i = 0; i < stretches.size(); ++i) {
    add_squares(stretches[i], i, kTileM, entries);
  }
  return entries;
}

bool tells_of_walls(double range_m, const RangeSensor& sensor) {
  constexpr double kMinRangeM = 0.2;
  constexpr double kMaxRangeM = 3.0;
  return range_m > kMinRangeM && range_m < std::min(kMaxRangeM, sensor.max_range_m);
}

std::optional<double> range_to_stretch(const ConeReturn& heard, double half_cone_rad,
                                       const WallStretch& wall) {
  // a wall is heard at its distance or farther: most are ruled out without its sines
  const double distance_m = wall.line.offset_m - wall.line.normal.dot(heard.sonar);
  if (distance_m <= 0.0 || distance_m > heard.range_m + kGateM) return std::nullopt;
  if (std::abs(wrap_angle(wall.line.normal_rad - heard.axis_rad)) > kMaxOffRad) return std::nullopt;
  const auto expected_m = range_to_line(heard, half_cone_rad, wall.line);
  if (!expected_m || std::abs(heard.range_m - *expected_m) > kGateM) return std::nullopt;
  const Point2 foot = foot_of(heard, half_cone_rad, wall.line);
  if (std::abs(wall.along.dot(foot - wall.middle)) > wall.half_length_m + kBesideM) {
    return std::nullopt;
  }
  return expected_m;
}

}  // namespace roomatlas
