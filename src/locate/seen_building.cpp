// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/locate/seen_building.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr double kFaceHits = 4.0;    // of the building's walls: all count alike
constexpr double kCoreM = 0.06;      // a wall this near to the middle of free floor stands on it
constexpr double kMinCosine = 0.7;   // between normals of walls that look the same way
constexpr double kCastStepM = 0.1;   // of a ray; the faces' own cells are as large
constexpr double kFaceReachM = 0.1;  // a face stands for so much of its wall to each side
constexpr double kMinFacing = 0.1;   // below it a ray runs along the wall
// A straight stretch of wall: so long, without a gap of a step, and as straight.
constexpr double kStretchM = 1.0;
constexpr double kStretchStepM = 0.1;
constexpr double kStretchOffM = 0.06;
constexpr double kStretchCosine = 0.95;

/// Where a ray meets the plane of a face, if it meets the face.
std::optional<SeenBuilding::Met> met_face(const Face& face, const Point2& from,
                                          const Point2& along) {
  const Point2 off = face.position - from;
  const double across = along.dot(face.normal);  // 0 for a face that has no normal
  const double range_m =
      std::abs(across) > kMinFacing ? off.dot(face.normal) / across : off.dot(along);
  const bool is_met = range_m >= 0.0 && (range_m * along - off).norm() <= kFaceReachM;
  if (!is_met) return std::nullopt;
  return SeenBuilding::Met{range_m, std::abs(across), true};
}

}  // namespace

double SeenBuilding::known_m2() const {
  return static_cast<double>(known_cells_) * kFloorCellM * kFloorCellM;
}

void SeenBuilding::note(TileGrid<char>& seen, const TileGrid<char>& other, const Cell& cell) {
  char& value = seen.edit(cell);
  if (value == 0 && other.at(cell) == 0) ++known_cells_;
  value = 1;
}

void SeenBuilding::add(const FloorSketch& sketch) {
  for (const ScanPoint& wall : sketch.walls) {
    faces_.add(Face{wall.position, wall.normal, kFaceHits});
    note(walls_, floor_, floor_cells().cell_of(wall.position));
  }
  for (const Point2& at : sketch.floor) note(floor_, walls_, floor_cells().cell_of(at));
}

bool SeenBuilding::is_floor(const Point2& at) const {
  return floor_.at(floor_cells().cell_of(at)) != 0;
}

bool SeenBuilding::has_wall_in(const Point2& floor) const {
  if (is_floor(floor)) return false;
  bool has_wall = false;
  faces_.for_each_face_near(floor, kCoreM, [&](const Face& face) {
    has_wall = has_wall || (face.position - floor).norm() <= kCoreM;
  });
  return has_wall;
}

std::optional<double> SeenBuilding::distance_to_wall(const Point2& at, const Point2& normal,
                                                     double reach_m) const {
  std::optional<double> least_m;
  faces_.for_each_face_near(at, reach_m, [&](const Face& face) {
    const Point2 off = face.position - at;
    if (off.norm() > reach_m) return;
    const bool has_normals = normal.squaredNorm() > 0.0 && face.normal.squaredNorm() > 0.0;
    if (has_normals && face.normal.dot(normal) < kMinCosine) return;
    const double off_m = has_normals ? std::abs(off.dot(face.normal)) : off.norm();
    least_m = std::min(least_m.value_or(off_m), off_m);
  });
  return least_m;
}

/// Whether the wall of a face is there so far along it.
bool SeenBuilding::goes_on_at(const Face& face, double along_m) const {
  const Point2 at = face.position + along_m * Point2{-face.normal.y(), face.normal.x()};
  bool is_there = false;
  faces_.for_each_face_near(at, kStretchStepM, [&](const Face& other) {
    const Point2 off = other.position - at;
    is_there = is_there ||
               (off.norm() <= kStretchStepM && std::abs(off.dot(face.normal)) <= kStretchOffM &&
                std::abs(other.normal.dot(face.normal)) > kStretchCosine);
  });
  return is_there;
}

bool SeenBuilding::is_on_stretch(const Face& face) const {
  if (face.normal.squaredNorm() == 0.0) return false;
  double length_m = 0.0;
  for (const double step_m : {-kStretchStepM, kStretchStepM}) {
    for (double along_m = step_m; goes_on_at(face, along_m); along_m += step_m) {
      length_m += kStretchStepM;
      if (length_m >= kStretchM) return true;
    }
  }
  return false;
}

template <typename Stops>
SeenBuilding::Met SeenBuilding::cast_until(const Pose2& building_from_beam, double reach_m,
                                           Stops stops) const {
  const Point2 from = building_from_beam.position();
  const Point2 along = direction(building_from_beam.theta_rad);
  for (double way_m = 0.0; way_m < reach_m; way_m += kCastStepM) {
    const Point2 at = from + way_m * along;
    const Cell cell = floor_cells().cell_of(at);
    if (walls_.at(cell) == 0) {
      if (floor_.at(cell) == 0) return {way_m, 0.0, false};
      continue;
    }
    Met first{reach_m, 0.0, false};
    faces_.for_each_face_near(at, kCastStepM, [&](const Face& face) {
      const std::optional<Met> met = met_face(face, from, along);
      if (met && met->range_m <= first.range_m && stops(face)) first = *met;
    });
    if (first.is_wall) return first;
  }
  return {reach_m, 0.0, false};
}

SeenBuilding::Met SeenBuilding::cast(const Pose2& building_from_beam, double reach_m) const {
  return cast_until(building_from_beam, reach_m, [](const Face&) { return true; });
}

SeenBuilding::Met SeenBuilding::cast_to_stretch(const Pose2& building_from_beam,
                                                double reach_m) const {
  return cast_until(building_from_beam, reach_m,
                    [&](const Face& face) { return is_on_stretch(face); });
}

}  // namespace roomatlas
