// SPDX-License-Identifier: GPL-3.0-or-later
#include "return_matches.hpp"

#include <algorithm>
#include <cmath>

#include "roomatlas/core/evenly.hpp"
#include "wall_stretches.hpp"

namespace roomatlas {
namespace {

constexpr double kLeastPathM = 1.0;    // nearer on the way: the return's own stretch
constexpr std::size_t kMostWalls = 3;  // of a return; more say the same

bool are_of_one_place(const SeenReturn& seen, const SeenWall& wall) {
  return wall.node == seen.node || std::abs(wall.path_m - seen.path_m) < kLeastPathM;
}

/// Some of the walls that were found, evenly over all of them.
void add_evenly(std::uint32_t heard, std::vector<std::uint32_t>& found,
                std::vector<ReturnMatch>& matches) {
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  keep_evenly(kMostWalls, found);
  for (const std::uint32_t wall : found) {
    matches.push_back({heard, wall, 1.0 / static_cast<double>(found.size())});
  }
}

}  // namespace

std::vector<ReturnMatch> find_return_matches(std::span<const SeenReturn> returns,
                                             std::span<const SeenWall> walls,
                                             std::span<const Pose2> map_from_node) {
  const WallStretches stretches(walls, map_from_node);
  std::vector<ReturnMatch> matches;
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < returns.size(); ++i) {
    const SeenReturn& seen = returns[i];
    const Pose2 sonar = map_from_node[seen.node] * seen.node_from_sonar;
    const ConeReturn heard{sonar.position(), sonar.theta_rad, seen.range_m};
    found.clear();
    stretches.for_each_near(heard.sonar + heard.range_m * heard.axis,
                            [&](std::uint32_t k, const WallStretch& wall) {
                              if (are_of_one_place(seen, walls[k])) return;
                              if (range_to_stretch(heard, seen.half_cone_rad, wall)) {
                                found.push_back(k);
                              }
                            });
    add_evenly(i, found, matches);
  }
  return matches;
}

}  // namespace roomatlas
