// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/bare_floor.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "roomatlas/polyline/small_part.hpp"
#include "wall_lines.hpp"

namespace roomatlas {
namespace {

constexpr double kBesideFace_m = 0.1;    // obstacles this near a wall's face are the wall's ...
constexpr double kBehindFace_m = 0.15;   // ... and this near behind it
constexpr double kNextFace_m = 4.0;      // posts and jambs stand between two faces on one line that
                                         // are no farther apart ...
constexpr double kBuildingLine_m = 5.0;  // ... or, with this much wall on the line ...
constexpr double kNextOnBuildingLine_m = 8.0;  // ... than this
constexpr double kLongestIsland_m = 3.2;  // more on one line is a wall, though behind it there is
                                          // something to see: it has windows
constexpr double kThickest_m = 0.4;       // piers between doors are not thicker; tables are
constexpr int kExtentDirections = 12;     // of half a turn

/// Obstacles on the face's line up to the next face on it: posts, jambs and pieces of the same wall
/// that are too short or too rough for faces.
void add_posts(const WallFace& face, const std::vector<WallFace>& faces, const Occupancy& occupancy,
               const BareFloorOptions& options, CellMask& mask) {
  Interval reach{face.low_m(), face.high_m()};
  const double next_m = face.prominence_m >= kBuildingLine_m ? kNextOnBuildingLine_m : kNextFace_m;
  for (const Interval& other : on_line(face, faces, options.min_face_m)) {
    if (other.low_m >= reach.high_m && other.low_m <= face.high_m() + next_m) {
      reach.high_m = std::max(reach.high_m, other.low_m);
    }
    if (other.high_m <= reach.low_m && other.high_m >= face.low_m() - next_m) {
      reach.low_m = std::min(reach.low_m, other.high_m);
    }
  }
  const double step_m = occupancy.frame.cell_m / 2.0;
  for (double along_m = reach.low_m; along_m <= reach.high_m; along_m += step_m) {
    for (double off_m = -kBehindFace_m; off_m <= kBesideFace_m; off_m += step_m) {
      const Cell cell = occupancy.frame.cell_of(face.at(along_m) + off_m * face.normal());
      if (occupancy.obstacle.at(cell)) mask.set(cell, true);
    }
  }
}

/// Where walls are for certain: the faces on prominent lines, and what lies between two faces.
CellMask wall_cells(const Walls& walls, const std::vector<bool>& is_wall,
                    const Occupancy& occupancy, const BareFloorOptions& options) {
  CellMask mask(occupancy.free.domain);
  for (std::size_t i = 0; i < walls.faces.size(); ++i) {
    const WallFace& face = walls.faces[i];
    if (!is_wall[i]) continue;
    for (const Interval& stretch : face.seen) mark(face, stretch, occupancy.frame, mask);
    if (face.is_regular) add_posts(face, walls.faces, occupancy, options, mask);
  }
  return mask;
}

/// Marks what lies between a wall and the floor in front of it: furniture that hides the wall.
void add_before_wall(const WallFace& face, double along_m, const CellMask& walls,
                     const Occupancy& occupancy, double depth_m, CellMask& hidden) {
  const double step_m = occupancy.frame.cell_m / 2.0;
  std::vector<Cell> passed;
  for (double off_m = 2.0 * step_m; off_m < depth_m; off_m += step_m) {
    const Cell cell = occupancy.frame.cell_of(face.at(along_m) + off_m * face.normal());
    if (occupancy.free.at(cell)) {
      for (const Cell& one : passed) hidden.set(one, true);
      return;
    }
    if (off_m > kBesideFace_m && walls.at(cell)) return;
    if (!walls.at(cell)) passed.push_back(cell);
  }
}

/// The least extent of cells over all directions, in cells.
double least_extent(const std::vector<Cell>& cells) {
  double least = 1e9;
  for (int step = 0; step < kExtentDirections; ++step) {
    const Point2 along = direction(kPi * step / kExtentDirections);
    double low = 1e9;
    double high = -1e9;
    for (const Cell& cell : cells) {
      const double at = along.dot(Point2(cell.x, cell.y));
      low = std::min(low, at);
      high = std::max(high, at);
    }
    least = std::min(least, high - low + 1.0);
  }
  return least;
}

/// Whether a part may be furniture: small, off the mask's rim, and beside floor, which the core of
/// a wall is not.
bool may_be_furniture(const std::vector<Cell>& part, int most_cells, const CellMask& floor) {
  if (part.empty()) return false;
  CellBox around{part.front(), part.front()};
  for (const Cell& at : part) {
    around.min = {std::min(around.min.x, at.x), std::min(around.min.y, at.y)};
    around.max = {std::max(around.max.x, at.x), std::max(around.max.y, at.y)};
  }
  if (std::max(around.width(), around.height()) >= most_cells) return false;
  if (std::any_of(part.begin(), part.end(),
                  [&](const Cell& cell) { return floor.domain.is_at_rim(cell); })) {
    return false;
  }
  return std::any_of(part.begin(), part.end(), [&](const Cell& cell) {
    return floor.at({cell.x + 1, cell.y}) || floor.at({cell.x - 1, cell.y}) ||
           floor.at({cell.x, cell.y + 1}) || floor.at({cell.x, cell.y - 1});
  });
}

/// Components of what is neither floor nor wall that are small enough for furniture become floor.
/// @param thicker_than_m only those that are thicker, as walls are not
void add_small(const CellMask& walls, double side_m, double thicker_than_m, Occupancy& bare) {
  const int most_cells = static_cast<int>(side_m / bare.frame.cell_m);
  const auto most = static_cast<std::size_t>(std::max(0, most_cells));
  CellMask is_done(bare.free.domain);
  for_each_cell(bare.free.domain, [&](const Cell& start) {
    if (is_done.at(start) || bare.free.at(start) || walls.at(start)) return;
    const std::vector<Cell> part = small_part(
        start, most * most,
        [&](const Cell& cell) { return !bare.free.at(cell) && !walls.at(cell); }, is_done);
    if (!may_be_furniture(part, most_cells, bare.free)) return;
    if (least_extent(part) * bare.frame.cell_m < thicker_than_m) return;
    for (const Cell& cell : part) bare.free.set(cell, true);
  });
}

/// What hides walls, from the floor in front of it to the wall.
CellMask hiding_cells(const Walls& walls, const std::vector<bool>& is_wall, const CellMask& lines,
                      const Occupancy& occupancy, double depth_m) {
  CellMask hiding(occupancy.free.domain);
  const double step_m = occupancy.frame.cell_m / 2.0;
  for (std::size_t i = 0; i < walls.faces.size(); ++i) {
    const WallFace& face = walls.faces[i];
    if (!is_wall[i] || !face.is_regular) continue;
    for (const Interval& cover : face.cover) {
      for (double along_m = cover.low_m; along_m <= cover.high_m; along_m += step_m) {
        add_before_wall(face, along_m, lines, occupancy, depth_m, hiding);
      }
    }
  }
  return hiding;
}

/// Where walls go on though nobody saw them there, up to the next wall: a wall that is hidden still
/// parts.
CellMask covered_cells(const Walls& walls, const std::vector<bool>& is_wall,
                       const Occupancy& occupancy) {
  CellMask covered(occupancy.free.domain);
  const double step_m = occupancy.frame.cell_m / 2.0;
  for (std::size_t i = 0; i < walls.faces.size(); ++i) {
    const WallFace& face = walls.faces[i];
    if (!is_wall[i] || !face.is_regular) continue;
    for (const Interval& cover : face.cover) {
      for (double along_m = cover.low_m; along_m <= cover.high_m; along_m += step_m) {
        const Cell cell = occupancy.frame.cell_of(face.at(along_m));
        if (!occupancy.free.at(cell)) covered.set(cell, true);
      }
    }
  }
  return covered;
}

/// The floor without what hides walls, sticks out of them or stands before them.
/// @param bare without what stands free
Occupancy bared(const Walls& walls, const std::vector<bool>& is_wall, CellMask lines,
                const Occupancy& occupancy, const BareFloorOptions& options, Occupancy bare) {
  for_each_cell(lines.domain, [&](const Cell& cell) {
    if (bare.free.at(cell) && !occupancy.free.at(cell)) lines.set(cell, false);  // stands free
  });
  const CellMask thick = dilated(lines, 1);
  const CellMask hiding = hiding_cells(walls, is_wall, lines, occupancy, options.furniture_depth_m);
  const CellMask covered = covered_cells(walls, is_wall, occupancy);
  CellMask wall(bare.free.domain);
  for_each_cell(bare.free.domain, [&](const Cell& cell) {
    const bool is_wall_here = thick.at(cell) && occupancy.obstacle.at(cell) && !hiding.at(cell);
    if (hiding.at(cell)) bare.free.set(cell, true);
    if (lines.at(cell) || is_wall_here || covered.at(cell)) bare.free.set(cell, false);
    wall.set(cell, (thick.at(cell) || covered.at(cell)) && !bare.free.at(cell));
  });
  add_small(wall, options.furniture_side_m, 0.0, bare);
  for_each_cell(bare.free.domain, [&](const Cell& cell) {
    if (bare.free.at(cell)) {
      bare.obstacle.set(cell, false);
      bare.seen.set(cell, true);
    } else if (wall.at(cell)) {
      bare.obstacle.set(cell, true);
    }
  });
  return bare;
}

}  // namespace

std::vector<bool> are_walls(const Walls& walls, const BareFloorOptions& options) {
  std::vector<bool> is_wall;
  for (const WallFace& face : walls.faces) {
    const double line_m = line_support_m(face, walls.faces);
    const bool is_closed = face.is_closed_behind || line_m >= kLongestIsland_m;
    const bool is_prominent =
        face.support_m() >= options.min_face_m && line_m >= options.min_prominence_m;
    const bool goes_on_behind = !face.hidden.empty() && line_m >= options.min_hidden_m;
    is_wall.push_back(!face.is_furniture && is_closed && (is_prominent || goes_on_behind));
  }
  for (const WallBody& body : walls.bodies) {
    const double both_m = walls.faces[body.front].support_m() + walls.faces[body.back].support_m();
    const bool is_thin = body.thickness_m <= options.thin_m;
    if (both_m < (is_thin ? options.min_thin_m : options.min_prominence_m)) continue;
    is_wall[body.front] = true;
    is_wall[body.back] = true;
  }
  return is_wall;
}

Occupancy bare_floor(const Walls& walls, const Occupancy& occupancy,
                     const BareFloorOptions& options) {
  Occupancy bare = occupancy;
  add_small(CellMask(CellBox{}), options.furniture_side_m, kThickest_m, bare);
  const std::vector<bool> is_wall = are_walls(walls, options);
  return bared(walls, is_wall, wall_cells(walls, is_wall, occupancy, options), occupancy, options,
               std::move(bare));
}

Occupancy bare_floor(const Walls& walls, const std::vector<bool>& is_wall,
                     const Occupancy& occupancy, const BareFloorOptions& options) {
  Occupancy bare = occupancy;
  CellMask lines = wall_cells(walls, is_wall, occupancy, options);
  add_small(lines, options.furniture_side_m, kThickest_m, bare);
  return bared(walls, is_wall, std::move(lines), occupancy, options, std::move(bare));
}

}  // namespace roomatlas
