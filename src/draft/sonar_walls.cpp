// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_walls.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "wall_lines.hpp"

namespace roomatlas {
namespace {

constexpr double kLongFace_m = 2.5;    // of one face, that needs nothing else to be a wall's
constexpr double kBothLong_m = 4.0;    // the same of the two faces of a wall ...
constexpr double kThinnest_m = 0.08;   // ... which a leaf's are nearer to each other than
constexpr double kLeast_m = 0.8;       // of a face between two walls ...
constexpr double kLeastShare = 0.5;    // ... and of the way between them
constexpr double kToWall_m = 1.2;      // a face ends this near to the wall that crosses it
constexpr double kPast_m = 0.35;       // of a wall's end, where the other may meet it
constexpr double kCrossingSine = 0.5;  // lines that cross at less do not end each other
constexpr double kFloorBand_m = 0.05;  // off a face's line, floor is on it
constexpr double kFloorStep_m = 0.05;
constexpr int kRounds = 3;  // a wall may end at one that ends at another

std::vector<bool> long_ones(const Walls& walls, const BareFloorOptions& options) {
  std::vector<bool> is_wall = are_walls(walls, options);
  for (std::size_t i = 0; i < is_wall.size(); ++i) {
    is_wall[i] = is_wall[i] && walls.faces[i].support_m() >= kLongFace_m;
  }
  for (const WallBody& body : walls.bodies) {
    const double both_m = walls.faces[body.front].support_m() + walls.faces[body.back].support_m();
    if (both_m < kBothLong_m) continue;
    if (body.thickness_m < kThinnest_m || body.thickness_m > options.thin_m) continue;
    is_wall[body.front] = true;
    is_wall[body.back] = true;
  }
  return is_wall;
}

/// How far beyond an end of a face the next wall crosses its line, unless floor lies between.
std::optional<double> to_wall_m(const WallFace& face, double end_m, double sign, const Walls& walls,
                                const std::vector<bool>& is_wall, const Occupancy& occupancy) {
  std::optional<double> next_m;
  for (std::size_t i = 0; i < walls.faces.size(); ++i) {
    if (!is_wall[i]) continue;
    const WallFace& wall = walls.faces[i];
    const auto beyond_m = crossing_m(face, end_m, sign, wall, kCrossingSine);
    if (!beyond_m || *beyond_m < -kPast_m || *beyond_m > next_m.value_or(kToWall_m)) continue;
    if (goes_on_at(wall, face.at(end_m + sign * *beyond_m), kPast_m)) next_m = beyond_m;
  }
  if (!next_m) return std::nullopt;
  double floor_m = 0.0;
  for (double on_m = 0.0; on_m < *next_m; on_m += kFloorStep_m) {
    bool is_floor = true;
    for (const double off_m : {-kFloorBand_m, 0.0, kFloorBand_m}) {
      const Point2 at = face.at(end_m + sign * on_m) + off_m * face.normal();
      is_floor = is_floor && occupancy.free.at(occupancy.frame.cell_of(at));
    }
    if (is_floor) floor_m += kFloorStep_m;
  }
  if (floor_m > kPast_m) return std::nullopt;
  return std::max(0.0, *next_m);
}

bool runs_between_walls(const WallFace& face, const Walls& walls, const std::vector<bool>& is_wall,
                        const Occupancy& occupancy) {
  if (face.is_furniture || !face.is_regular || face.support_m() < kLeast_m) return false;
  for (std::size_t k = 1; k < face.seen.size(); ++k) {
    if (face.seen[k].low_m - face.seen[k - 1].high_m >= kToWall_m) return false;
  }
  const auto low_m = to_wall_m(face, face.low_m(), -1.0, walls, is_wall, occupancy);
  const auto high_m = to_wall_m(face, face.high_m(), 1.0, walls, is_wall, occupancy);
  if (!low_m || !high_m) return false;
  const double whole_m = *low_m + face.high_m() - face.low_m() + *high_m;
  return face.support_m() >= kLeastShare * whole_m;
}

}  // namespace

std::vector<bool> sonar_walls(const Walls& walls, const Occupancy& occupancy,
                              const BareFloorOptions& options) {
  std::vector<bool> is_wall = long_ones(walls, options);
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < walls.faces.size(); ++i) {
      if (is_wall[i]) continue;
      is_wall[i] = runs_between_walls(walls.faces[i], walls, is_wall, occupancy);
    }
  }
  return is_wall;
}

}  // namespace roomatlas
