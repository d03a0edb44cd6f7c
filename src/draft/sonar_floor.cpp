// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_floor.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "wall_lines.hpp"

namespace roomatlas {
namespace {

constexpr double kAlongFace_m = 0.05;      // along a face
constexpr double kNearFurniture_m = 0.25;  // echoes this near to furniture are its ...
constexpr double kNearWall_m = 0.15;       // ... unless a wall is this near
constexpr double kOnWall_m = 0.3;          // echoes this near to a wall's face may be its own
constexpr double kAround_m = 0.25;         // a wall that is followed: its echoes are this near
constexpr int kMostSteps = 100;            // cells along it
constexpr int kMostMissed = 3;             // of them without an echo
constexpr double kTellsFrom_m = 1.0;       // so much of it tells its direction ...
constexpr double kMostBent = 0.9;          // ... cosine; what turns off more is another wall

/// Whether most of a stretch is solid on the bare floor.
bool stays(const WallFace& face, const Interval& stretch, const Occupancy& bare) {
  const int steps = std::max(1, static_cast<int>(stretch.length_m() / kAlongFace_m));
  int solid = 0;
  for (int k = 0; k <= steps; ++k) {
    const Point2 at = face.at(stretch.low_m + stretch.length_m() * k / steps);
    if (!bare.free.at(bare.frame.cell_of(at))) ++solid;
  }
  return 2 * solid > steps;
}

void set_solid(const Cell& cell, BuildingGrid& grid) {
  grid.obstacle.set(cell, true);
  grid.free.set(cell, false);
  grid.passable.set(cell, false);
}

/// What was heard of furniture becomes free.
void free_furniture(const Walls& walls, const Occupancy& occupancy, const Occupancy& bare,
                    BuildingGrid& grid) {
  const CellFrame& frame = grid.frame;
  CellMask wall(grid.free.domain);
  CellMask gone(grid.free.domain);
  for (const WallFace& face : walls.faces) {
    for (const Interval& stretch : face.seen) {
      mark(face, stretch, frame, stays(face, stretch, bare) ? wall : gone);
    }
  }
  for_each_cell(bare.free.domain, [&](const Cell& cell) {
    if (!bare.free.at(cell) || occupancy.free.at(cell)) return;
    gone.set(frame.cell_of(bare.frame.center_of(cell)), true);
  });
  const auto cells = [&](double m) { return static_cast<int>(std::lround(m / frame.cell_m)); };
  const CellMask near_wall = dilated(wall, cells(kNearWall_m));
  const CellMask near_gone = dilated(gone, cells(kNearFurniture_m));
  for_each_cell(grid.free.domain, [&](const Cell& cell) {
    if (wall.at(cell) || !near_gone.at(cell)) return;
    if (grid.obstacle.at(cell) ? near_wall.at(cell) : !gone.at(cell)) return;
    grid.obstacle.set(cell, false);
    grid.free.set(cell, true);
  });
}

}  // namespace

void take_furniture_out(const Walls& walls, const std::vector<bool>& is_wall,
                        const Occupancy& occupancy, const Occupancy& bare, BuildingGrid& grid) {
  free_furniture(walls, occupancy, bare, grid);
  CellMask on_wall(bare.free.domain);
  for (std::size_t i = 0; i < walls.faces.size(); ++i) {
    if (!is_wall[i]) continue;
    for (const Interval& stretch : walls.faces[i].cover) {
      mark(walls.faces[i], stretch, bare.frame, on_wall);
    }
  }
  const auto in_grid = [&](const Cell& cell) {
    return grid.frame.cell_of(bare.frame.center_of(cell));
  };
  for_each_cell(bare.free.domain, [&](const Cell& cell) {
    const Cell at = in_grid(cell);
    if (bare.free.at(cell) && !grid.obstacle.at(at)) grid.free.set(at, true);
  });
  for_each_cell(bare.free.domain, [&](const Cell& cell) {
    if (!bare.free.at(cell) && on_wall.at(cell)) set_solid(in_grid(cell), grid);
  });
}

double share_on_no_wall(const Walls& walls, const std::vector<bool>& is_wall,
                        const BuildingGrid& heard) {
  CellMask near(heard.obstacle.domain);
  for (std::size_t i = 0; i < walls.faces.size(); ++i) {
    if (!is_wall[i]) continue;
    for (const Interval& one : walls.faces[i].seen) mark(walls.faces[i], one, heard.frame, near);
  }
  near = dilated(near, static_cast<int>(std::lround(kOnWall_m / heard.frame.cell_m)));
  double all = 0.0;
  double off = 0.0;
  for_each_cell(near.domain, [&](const Cell& cell) {
    if (!heard.obstacle.at(cell)) return;
    all += 1.0;
    if (!near.at(cell)) off += 1.0;
  });
  return all > 0.0 ? off / all : 0.0;
}

void find_passable(const std::vector<Pose2>& path, double margin_m, BuildingGrid& grid) {
  std::vector<Cell> on_path;
  on_path.reserve(path.size());
  for (const Pose2& pose : path) on_path.push_back(grid.frame.cell_of(pose.position()));
  grid.passable = eroded(grid.free, static_cast<int>(std::lround(margin_m / grid.frame.cell_m)));
  for (const Cell& cell : on_path) grid.passable.set(cell, true);
  grid.passable = connected_to(grid.passable, on_path);
}

void close_beside(const Segment2& jambs, double most_m, BuildingGrid& grid) {
  const Point2 along = (jambs.b - jambs.a).normalized();
  const std::array<Segment2, 2> beside = {Segment2{jambs.a, jambs.a - most_m * along},
                                          Segment2{jambs.b, jambs.b + most_m * along}};
  for (const Segment2& stub : beside) {
    for_each_cell_on_line(grid.frame.cell_of(stub.a), grid.frame.cell_of(stub.b),
                          [&](const Cell& cell) {
                            if (grid.obstacle.at(cell)) return false;
                            set_solid(cell, grid);
                            return true;
                          });
  }
}

void restore_beside(const Segment2& jambs, const BuildingGrid& heard, BuildingGrid& grid) {
  const CellFrame& frame = heard.frame;
  const Point2 along = (jambs.b - jambs.a).normalized();
  for (const auto& [jamb, way] : {std::pair(jambs.a, Point2(-along)), std::pair(jambs.b, along)}) {
    Point2 at = jamb;
    Point2 going = way;
    int missed = 0;
    for (int step = 0; step < kMostSteps && missed <= kMostMissed; ++step) {
      at += frame.cell_m * going;
      Point2 sum = Point2::Zero();
      int found = 0;
      const CellBox around{frame.cell_of(at - Point2::Constant(kAround_m)),
                           frame.cell_of(at + Point2::Constant(kAround_m))};
      for_each_cell(around, [&](const Cell& cell) {
        if (!heard.obstacle.at(cell)) return;
        set_solid(cell, grid);
        sum += frame.center_of(cell) - at;
        ++found;
      });
      missed = found == 0 ? missed + 1 : 0;
      if (found == 0) continue;
      const Point2 across(-going.y(), going.x());
      at += 0.5 * (sum / found).dot(across) * across;
      if ((at - jamb).norm() <= kTellsFrom_m) continue;
      going = (at - jamb).normalized();
      if (going.dot(way) < kMostBent) break;
    }
  }
}

}  // namespace roomatlas
