// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "square_index.hpp"

namespace roomatlas {
namespace {

constexpr double kTileM = 3.0;      // a wall's middle and those it can be paired with
constexpr double kWideGateM = 0.4;  // wider ones ask no less overlap

/// A wall in the map, and what asks whether it pairs wants of it.
struct WallInMap {
  Point2 middle = Point2::Zero();
  Point2 normal = Point2::Zero();
  double normal_rad = 0.0;
  double length_m = 0.0;
  double path_m = 0.0;
};

std::vector<WallInMap> placed(std::span<const SeenWall> walls,
                              std::span<const Pose2> map_from_node) {
  std::vector<WallInMap> result;
  result.reserve(walls.size());
  for (const SeenWall& wall : walls) {
    const Pose2& pose = map_from_node[wall.node];
    const double normal_rad = wrap_angle(pose.theta_rad + wall.normal_rad);
    result.push_back(
        {pose * wall.middle_node, direction(normal_rad), normal_rad, wall.length_m, wall.path_m});
  }
  return result;
}

std::vector<SquareIndex::Entry> squares_of(const std::vector<WallInMap>& walls) {
  std::vector<SquareIndex::Entry> entries;
  entries.reserve(walls.size());
  for (std::uint32_t i = 0; i < walls.size(); ++i) {
    entries.push_back({square_of(walls[i].middle, kTileM), i});
  }
  return entries;
}

/// How far the second's middle is from the middle of the overlap, along the first's wall; nothing
/// where the two are not one wall.
std::optional<double> overlap_of(const WallInMap& a, const WallInMap& b, double scale_m,
                                 const WallPairOptions& options) {
  if (std::abs(wrap_angle(a.normal_rad - b.normal_rad)) > options.max_turn_rad) {
    return std::nullopt;
  }
  const double way_m = std::abs(a.path_m - b.path_m);
  if (way_m < options.min_path_m) return std::nullopt;
  const Point2 between = b.middle - a.middle;
  const double gate_m =
      std::min(2.0 * scale_m, options.near_gate_m + options.gate_per_path * way_m);
  if (std::abs(a.normal.dot(between)) > gate_m) return std::nullopt;
  const double along = a.normal.x() * between.y() - a.normal.y() * between.x();
  const double low = std::max(-a.length_m / 2.0, along - b.length_m / 2.0);
  const double high = std::min(a.length_m / 2.0, along + b.length_m / 2.0);
  const double asked_m =
      options.min_overlap_m - options.overlap_per_gate * std::min(gate_m, kWideGateM);
  if (high - low < asked_m) return std::nullopt;
  return (low + high) / 2.0 - along;
}

}  // namespace

std::vector<WallPair> find_wall_pairs(std::span<const SeenWall> walls,
                                      std::span<const Pose2> map_from_node, double scale_m,
                                      const WallPairOptions& options) {
  const std::vector<WallInMap> placed_walls = placed(walls, map_from_node);
  const SquareIndex near(squares_of(placed_walls));
  std::vector<WallPair> pairs;
  for (std::uint32_t i = 0; i < placed_walls.size(); ++i) {
    const WallInMap& wall = placed_walls[i];
    const Square square = square_of(wall.middle, kTileM);
    const std::size_t of_earlier = pairs.size();
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        const auto there = near.at({square.x + dx, square.y + dy});
        for (auto j = std::upper_bound(there.begin(), there.end(), i); j != there.end(); ++j) {
          if (const auto along = overlap_of(wall, placed_walls[*j], scale_m, options)) {
            pairs.push_back({i, *j, *along});
          }
        }
      }
    }
    std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(of_earlier), pairs.end(),
              [](const WallPair& a, const WallPair& b) { return a.second < b.second; });
  }
  return pairs;
}

}  // namespace roomatlas
