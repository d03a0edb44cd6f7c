// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace roomatlas {
namespace {

constexpr double kTileM = 3.0;      // a wall's middle and those it can be paired with
constexpr double kWideGateM = 0.4;  // wider ones ask no less overlap

struct PlacedWall {
  Point2 middle;
  Point2 normal;
  double normal_rad;
};

using Tile = std::pair<int, int>;

Tile tile_of(const Point2& point) {
  return {static_cast<int>(std::floor(point.x() / kTileM)),
          static_cast<int>(std::floor(point.y() / kTileM))};
}

std::vector<PlacedWall> placed(std::span<const SeenWall> walls,
                               std::span<const Pose2> map_from_node) {
  std::vector<PlacedWall> result;
  for (const SeenWall& wall : walls) {
    const Pose2& pose = map_from_node[wall.node];
    const double normal_rad = wrap_angle(pose.theta_rad + wall.normal_rad);
    result.push_back({pose * wall.middle_node, direction(normal_rad), normal_rad});
  }
  return result;
}

/// How far the second's middle is from the middle of the overlap, along the first's wall; nothing
/// where the two are not one wall.
std::optional<double> overlap_of(const SeenWall& a, const SeenWall& b, const PlacedWall& at_a,
                                 const PlacedWall& at_b, double scale_m,
                                 const WallPairOptions& options) {
  const double way_m = std::abs(a.path_m - b.path_m);
  if (way_m < options.min_path_m) return std::nullopt;
  if (std::abs(wrap_angle(at_a.normal_rad - at_b.normal_rad)) > options.max_turn_rad) {
    return std::nullopt;
  }
  const Point2 between = at_b.middle - at_a.middle;
  const double gate_m =
      std::min(2.0 * scale_m, options.near_gate_m + options.gate_per_path * way_m);
  if (std::abs(at_a.normal.dot(between)) > gate_m) return std::nullopt;
  const double along = at_a.normal.x() * between.y() - at_a.normal.y() * between.x();
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
  const std::vector<PlacedWall> at = placed(walls, map_from_node);
  std::map<Tile, std::vector<std::size_t>> tiles;
  for (std::size_t i = 0; i < walls.size(); ++i) tiles[tile_of(at[i].middle)].push_back(i);
  std::vector<WallPair> pairs;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const Tile tile = tile_of(at[i].middle);
    const std::size_t of_earlier = pairs.size();
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        const auto found = tiles.find({tile.first + dx, tile.second + dy});
        if (found == tiles.end()) continue;
        for (const std::size_t j : found->second) {
          if (j <= i) continue;
          if (const auto along = overlap_of(walls[i], walls[j], at[i], at[j], scale_m, options)) {
            pairs.push_back({i, j, *along});
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
