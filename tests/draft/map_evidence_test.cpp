// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/map_evidence.hpp"
#include "roomatlas/draft/building_axes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "roomatlas/draft/draft_building.hpp"

namespace roomatlas {
namespace {

constexpr double kWall_m = 0.2;

struct Rectangle {
  Point2 low;
  Point2 high;
  [[nodiscard]] bool has(const Point2& at) const {
    return at.x() > low.x() && at.x() < high.x() && at.y() > low.y() && at.y() < high.y();
  }
  [[nodiscard]] double area_m2() const { return (high - low).prod(); }
};

// Two rooms over a corridor, and a door of 0.9 m from each of them into it.
const std::vector<Rectangle> kRooms = {
    {{0.0, 0.0}, {9.2, 2.0}}, {{0.0, 2.2}, {4.0, 6.2}}, {{4.2, 2.2}, {9.2, 6.2}}};
const std::vector<Rectangle> kDoors = {{{1.5, 1.9}, {2.4, 2.3}}, {{6.5, 1.9}, {7.4, 2.3}}};
const Rectangle kHouse{{-kWall_m, -kWall_m}, {9.2 + kWall_m, 6.2 + kWall_m}};

/// The house drawn into cells, turned about its corner. Around it nothing is known.
MapCells house_map(double cell_m, double turn_rad, MapCell around = MapCell::unknown) {
  MapCells map{{cell_m}, {}, {}};
  const int reach = static_cast<int>(18.0 / cell_m);
  map.cells = Raster<MapCell>({{0, 0}, {reach, reach}}, around);
  const Pose2 map_from_house{5.0, 1.5, turn_rad};
  map.building_from_map = inverse(map_from_house);  // the house's frame is the building's
  const auto in_any = [](const std::vector<Rectangle>& parts, const Point2& at) {
    return std::any_of(parts.begin(), parts.end(), [&](const auto& part) { return part.has(at); });
  };
  for_each_cell(map.cells.domain, [&](const Cell& cell) {
    const Point2 at = map.building_from_map * map.frame.center_of(cell);
    if (in_any(kRooms, at) || in_any(kDoors, at)) {
      map.cells[cell] = MapCell::free;
    } else if (kHouse.has(at)) {
      map.cells[cell] = MapCell::occupied;
    }
  });
  return map;
}

MappedBuilding drafted(const MapCells& map) {
  const BuildingEvidence evidence = evidence_of_map(map);
  return moved(mapped_building_of(draft_building(evidence, {}), evidence, {}),
               map.building_from_map);
}

/// How far a drawn corner is from the nearest true one, at most; over true rooms.
double worst_corner_m(const MappedBuilding& building, const Rectangle& room) {
  const auto holds = [&](const PlacedOutline& outline) {
    return contains(outline.outline, (room.low + room.high) / 2.0);
  };
  const auto found = std::find_if(building.outlines.begin(), building.outlines.end(), holds);
  if (found == building.outlines.end()) return 1e9;
  double worst_m = 0.0;
  for (const Point2& corner : {room.low, room.high, Point2(room.low.x(), room.high.y()),
                               Point2(room.high.x(), room.low.y())}) {
    double nearest_m = 1e9;
    for (const Point2& point : found->outline.outer) {
      nearest_m = std::min(nearest_m, (point - corner).norm());
    }
    worst_m = std::max(worst_m, nearest_m);
  }
  EXPECT_NEAR(area(found->outline), room.area_m2(), 0.05 * room.area_m2());
  return worst_m;
}

struct Drawing {
  double cell_m;
  double turn_deg;
};

class DrawnHouse : public ::testing::TestWithParam<Drawing> {};

TEST_P(DrawnHouse, ComesBackWithinACell) {
  const double cell_m = GetParam().cell_m;
  const MappedBuilding building = drafted(house_map(cell_m, radians(GetParam().turn_deg)));
  ASSERT_EQ(building.outlines.size(), kRooms.size());
  for (const Rectangle& room : kRooms) {
    EXPECT_LT(worst_corner_m(building, room), std::sqrt(2.0) * cell_m);
  }
  ASSERT_EQ(building.doors.size(), kDoors.size());
  for (const Rectangle& door : kDoors) {
    const Point2 middle = (door.low + door.high) / 2.0;
    const auto nearest = std::min_element(building.doors.begin(), building.doors.end(),
                                          [&](const Door& a, const Door& b) {
                                            return (a.frame_from_pivot.position() - middle).norm() <
                                                   (b.frame_from_pivot.position() - middle).norm();
                                          });
    EXPECT_LT((nearest->frame_from_pivot.position() - middle).norm(), 0.2);
    EXPECT_NEAR(nearest->width_m, 0.9, 2.5 * cell_m);
    EXPECT_FALSE(nearest->is_driven);
  }
}

INSTANTIATE_TEST_SUITE_P(CellsAndTurns, DrawnHouse,
                         ::testing::Values(Drawing{0.05, 0.0}, Drawing{0.05, 3.0},
                                           Drawing{0.05, 20.0}, Drawing{0.05, 45.0},
                                           Drawing{0.02, 20.0}, Drawing{0.1, 0.0}));

TEST(MapSurfaces, LieOnTheWallsAndLookAtTheFloor) {
  const MapCells map = house_map(0.05, radians(7.0));
  const std::vector<SurfacePoint> points = surfaces_of(map);
  ASSERT_FALSE(points.empty());
  double worst_m = 0.0;
  int turned = 0;
  int astray = 0;
  double weight = 0.0;
  for (const SurfacePoint& point : points) {
    const Point2 at = map.building_from_map * point.at;
    const double turn_rad = point.normal_rad - radians(7.0);
    double off_m = 1e9;  // of the nearest true wall
    std::vector<Rectangle> floors = kRooms;
    floors.insert(floors.end(), kDoors.begin(), kDoors.end());
    for (const Rectangle& floor : floors) {
      const double dx = std::max({floor.low.x() - at.x(), at.x() - floor.high.x()});
      const double dy = std::max({floor.low.y() - at.y(), at.y() - floor.high.y()});
      off_m = std::min(off_m, std::abs(std::max(dx, dy)));
    }
    worst_m = std::max(worst_m, off_m);
    if (std::abs(wrap_quarter(turn_rad)) > radians(6.0)) ++turned;
    weight += point.weight;
    const Cell before = map.frame.cell_of(point.at + 0.08 * direction(point.normal_rad));
    if (map.cells.get(before) != MapCell::free) ++astray;
  }
  EXPECT_LT(worst_m, 0.05);
  EXPECT_LT(astray, static_cast<int>(points.size()) / 100);
  EXPECT_LT(turned, static_cast<int>(points.size()) / 10);  // at corners
  // As many beams a metre of wall everywhere: 80, but for the corners.
  const double around_m = 2.0 * (9.2 + 2.0 + 4.0 + 4.0 + 5.0 + 4.0) - 4.0 * 0.9 + 4.0 * 0.2;
  EXPECT_NEAR(weight / 80.0, around_m, 0.1 * around_m);
}

TEST(MapEvidence, WhatLiesOutsideOfTheBuildingIsNotFloor) {
  const MapCells map = house_map(0.05, 0.0, MapCell::free);  // white paper around
  const BuildingEvidence evidence = evidence_of_map(map);
  EXPECT_FALSE(evidence.counts.at({2, 2}).is_seen());
  const Point2 room = inverse(map.building_from_map) * Point2(2.0, 4.0);
  EXPECT_GT(evidence.counts.at(map.frame.cell_of(room)).passes, 0);
  EXPECT_EQ(drafted(map).outlines.size(), kRooms.size());
}

TEST(MapEvidence, GlimpsesThroughWindowsAreNotFloor) {
  MapCells map = house_map(0.05, 0.0);
  for_each_cell({{10, 200}, {60, 260}}, [&](const Cell& cell) {  // 7.5 m2 with no wall at all
    ASSERT_EQ(map.cells[cell], MapCell::unknown);
    map.cells[cell] = MapCell::free;
  });
  EXPECT_FALSE(evidence_of_map(map).counts.at({30, 230}).is_seen());
}

TEST(MapEvidence, FinerMapsKeepThinWallsInLargerCells) {
  MapCells map{{0.01}, Raster<MapCell>({{0, 0}, {400, 400}}, MapCell::free), {}};
  for (int y = 0; y < 400; ++y) map.cells[{203, y}] = MapCell::occupied;  // 1 cm
  const BuildingEvidence evidence = evidence_of_map(map);
  EXPECT_NEAR(evidence.counts.frame().cell_m, 0.05, 1e-12);
  EXPECT_GT(evidence.counts.at({40, 10}).hits, 0);
  EXPECT_GT(evidence.counts.at({39, 10}).passes, 0);
}

TEST(MapEvidence, NothingFreeGivesNothing) {
  const MapCells map{{0.05}, Raster<MapCell>({{0, 0}, {9, 9}}, MapCell::occupied), {}};
  EXPECT_TRUE(evidence_of_map(map).surfaces.empty());
  EXPECT_THROW((void)evidence_of_map({{0.0}, {}, {}}), std::invalid_argument);
}

}  // namespace
}  // namespace roomatlas
