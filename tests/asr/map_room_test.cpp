// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/asr/map_room.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "support/drawn_world.hpp"

namespace roomatlas {
namespace {

using namespace test;

/// A room of 6 m x 4.2 m with an open door of 0.9 m in the wall on the right, which is 0.3 m
/// thick; the other room is seen through the door.
const WorldDrawing kRoom = {"##################################",  //
                            "#                    #           #",  //
                            "#  b              a  #           #",  //
                            "#                    #           #",  //
                            "#                    #           #",  //
                            "#                    #           #",  //
                            "#                    #           #",  //
                            "#                                #",  //
                            "#                                #",  //
                            "#                                #",  //
                            "#                    #           #",  //
                            "#                    #           #",  //
                            "#  c              d  #           #",  //
                            "#                    #           #",  //
                            "#                    #           #",  //
                            "##################################"};
const Segment2 kDoorLine{{6.3, 2.7}, {6.3, 1.8}};
const double kFreeArea = 6.0 * 4.2;

/// What the robot has when it has left the room.
struct Visit {
  Pose2 asr_from_world;
  std::vector<PathSample> path;
  std::vector<RangeReading> readings;
  std::vector<Exit> exits;
};

Visit visit_to_room(const Pose2& asr_from_world = {-1.37, -2.41, 0.0}, double noise_m = 0.02) {
  LaserRobot robot;
  robot.noise_m = noise_m;
  robot.odom_from_world = asr_from_world;
  Visit visit{asr_from_world, {}, readings_in(kRoom, robot), {}};
  for (const RangeReading& reading : visit.readings) {
    visit.path.push_back({reading.timestamp_s, reading.odom_from_robot, reading.odom_from_robot});
  }
  Exit exit;
  const Point2 pivot = (kDoorLine.a + kDoorLine.b) / 2.0;
  exit.frame_from_pivot = asr_from_world * Pose2{pivot.x(), pivot.y(), 0.0};
  exit.width_m = 0.9;
  exit.jambs = transformed(asr_from_world, kDoorLine);
  visit.exits = {exit};
  return visit;
}

RoomMap map_of(const Visit& visit, const RoomMapOptions& options = {}) {
  return map_room(visit.path, visit.readings, visit.exits, {}, options);
}

double distance_to(const std::vector<Segment2>& surfaces, const Point2& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Segment2& surface : surfaces) nearest = std::min(nearest, distance(surface, point));
  return nearest;
}

/// Points every centimetre or so along the walls, in the world's frame.
std::vector<Point2> points_on_walls(const RoomMap& map, const Pose2& asr_from_world) {
  std::vector<Point2> points;
  for (const WallPolyline& wall : map.walls) {
    for (std::size_t i = 1; i < wall.vertices_asr.size(); ++i) {
      const Point2 from = wall.vertices_asr[i - 1];
      const Point2 along = wall.vertices_asr[i] - from;
      const int steps = 1 + static_cast<int>(along.norm() / 0.01);
      for (int k = 0; k <= steps; ++k) {
        points.push_back(inverse(asr_from_world) * Point2(from + along * k / steps));
      }
    }
  }
  return points;
}

bool has_vertex(const Ring& ring, const Point2& point) {
  return std::any_of(ring.begin(), ring.end(),
                     [&](const Point2& vertex) { return (vertex - point).norm() < 1e-9; });
}

TEST(MapRoom, DrawsWallsWithinFiveCentimetresOfTheTruth) {
  const Visit visit = visit_to_room();
  const std::vector<Point2> points = points_on_walls(map_of(visit), visit.asr_from_world);
  ASSERT_FALSE(points.empty());
  for (const Point2& point : points) {
    // Beside a jamb stands the corner of the wall, which a cell of 10 cm rounds.
    const bool is_at_jamb =
        std::min((point - kDoorLine.a).norm(), (point - kDoorLine.b).norm()) < 0.2;
    EXPECT_LE(distance_to(surfaces_of(kRoom), point), is_at_jamb ? 0.1 : 0.05) << point.transpose();
  }
}

TEST(MapRoom, SimplifiesWhatSonarsSawByAToleranceOfItsOwn) {
  Visit visit = visit_to_room();
  const auto vertices = [&](double laser_m, double sonar_m) {
    RoomMapOptions options;
    options.simplify_tolerance_m = laser_m;
    options.sonar_simplify_tolerance_m = sonar_m;
    return map_of(visit, options).counters.vertices;
  };
  const std::int64_t fine = vertices(0.01, 0.5);
  EXPECT_GT(fine, vertices(0.5, 0.01));
  EXPECT_EQ(fine, vertices(0.01, 0.01)) << "a laser does not use the sonars' tolerance";

  RangeSensor sonars = *visit.readings.front().sensor;
  sonars.kind = SensorKind::sonar;
  for (RangeReading& reading : visit.readings) {
    reading.sensor = std::make_shared<const RangeSensor>(sonars);
  }
  EXPECT_GT(vertices(0.5, 0.01), vertices(0.01, 0.5));
}

TEST(MapRoom, DrawsAllWallsOfTheRoom) {
  const Visit visit = visit_to_room();
  const std::vector<Point2> points = points_on_walls(map_of(visit), visit.asr_from_world);
  int seen = 0;
  int all = 0;
  for (double along_m = 0.05; along_m < 6.0; along_m += 0.1) {
    for (const Point2& truth : {Point2(0.3 + along_m, 0.3), Point2(0.3 + along_m, 4.5),
                                Point2(0.3, 0.3 + 0.7 * along_m)}) {
      ++all;
      seen += std::any_of(points.begin(), points.end(),
                          [&](const Point2& point) { return (point - truth).norm() < 0.1; });
    }
  }
  EXPECT_GE(seen, 0.95 * all);
}

TEST(MapRoom, OutlinesTheFreeSpaceWithinFivePercent) {
  for (const double turn_deg : {0.0, 30.0, 90.0, -137.0}) {
    const Visit visit = visit_to_room({0.51, -3.33, radians(turn_deg)});
    const RoomMap map = map_of(visit);
    EXPECT_NEAR(area(map.outline), kFreeArea, 0.05 * kFreeArea) << turn_deg;
    EXPECT_TRUE(map.outline.holes.empty()) << turn_deg;
    EXPECT_TRUE(contains(map.outline, map.reference_point)) << turn_deg;
  }
}

TEST(MapRoom, MapsNothingBeyondTheDoorLine) {
  const Visit visit = visit_to_room();
  const RoomMap map = map_of(visit);
  const double limit_m = kDoorLine.a.x() + 0.1;  // the cell that the door line runs through
  for (const Point2& point : points_on_walls(map, visit.asr_from_world)) {
    EXPECT_LE(point.x(), limit_m);
  }
  for (const Point2& vertex : transformed(inverse(visit.asr_from_world), map.outline.outer)) {
    EXPECT_LE(vertex.x(), limit_m);
  }
}

TEST(MapRoom, MapsTheOtherRoomTooWhenThereIsNoDoorLine) {
  Visit visit = visit_to_room();
  visit.exits.clear();
  double farthest_m = 0.0;
  for (const Point2& point : points_on_walls(map_of(visit), visit.asr_from_world)) {
    farthest_m = std::max(farthest_m, point.x());
  }
  EXPECT_GT(farthest_m, 7.0) << "the readings do go through the door";
}

TEST(MapRoom, HasTheJambsAmongTheVerticesOfTheOutline) {
  for (const double turn_deg : {0.0, 30.0, 90.0, -137.0}) {
    const Visit visit = visit_to_room({0.51, -3.33, radians(turn_deg)});
    const RoomMap map = map_of(visit);
    EXPECT_TRUE(has_vertex(map.outline.outer, visit.exits[0].jambs.a)) << turn_deg;
    EXPECT_TRUE(has_vertex(map.outline.outer, visit.exits[0].jambs.b)) << turn_deg;
  }
}

TEST(MapRoom, GivesTheSameForTheSameReadings) {
  const Visit visit = visit_to_room();
  const RoomMap first = map_of(visit);
  const RoomMap second = map_of(visit);
  ASSERT_EQ(first.walls.size(), second.walls.size());
  for (std::size_t i = 0; i < first.walls.size(); ++i) {
    EXPECT_EQ(first.walls[i].vertices_asr, second.walls[i].vertices_asr);
    EXPECT_EQ(first.walls[i].edge_is_fitted, second.walls[i].edge_is_fitted);
  }
  EXPECT_EQ(first.outline.outer, second.outline.outer);
  EXPECT_EQ(first.outline.holes, second.outline.holes);
  EXPECT_EQ(first.reference_point, second.reference_point);
}

TEST(MapRoom, CountsWhatItHasMade) {
  Visit visit = visit_to_room();
  visit.readings[0].ranges_m[3] = std::numeric_limits<float>::quiet_NaN();
  visit.readings[0].ranges_m[4] = -1.0F;
  const RoomMap map = map_of(visit);
  std::int64_t vertices = 0;
  for (const WallPolyline& wall : map.walls) {
    vertices += static_cast<std::int64_t>(wall.vertices_asr.size());
    EXPECT_EQ(wall.edge_is_fitted.size() + 1, wall.vertices_asr.size());
  }
  const AsrCounters& counters = map.counters;
  EXPECT_EQ(counters.vertices, vertices);
  EXPECT_EQ(counters.geometry_bytes, vertices * 8);
  EXPECT_EQ(counters.grid_bytes, counters.grid_cells) << "one byte a cell";
  EXPECT_EQ(counters.ignored_ranges, 2);
  EXPECT_GE(counters.occupied_cells, counters.cleaned_cells);
  EXPECT_GE(counters.cleaned_cells, counters.extracted_points);
  EXPECT_GE(counters.extracted_points, counters.vertices);
  EXPECT_GT(counters.vertices, 0);

  Box2 known;  // second route: the box around all cells that were touched
  for_each_cell(map.grid.box(), [&](const Cell& cell) {
    if (map.grid.raw(cell) != 0) known.extend(Point2(cell.x, cell.y));
  });
  EXPECT_EQ(static_cast<double>(counters.grid_cells),
            (known.size().x() + 1.0) * (known.size().y() + 1.0));
}

TEST(MapRoom, MakesAnEmptyMapOfNoReadings) {
  const RoomMap map = map_room({}, {}, {}, {}, {});
  EXPECT_TRUE(map.walls.empty());
  EXPECT_TRUE(map.outline.outer.empty());
  EXPECT_EQ(map.counters.grid_cells, 0);
}

TEST(MapRoom, IsNotWornOutByARobotThatStandsStill) {
  Visit visit = visit_to_room();
  const RoomMap once = map_of(visit);
  const PathSample last = visit.path.back();
  const RangeReading again = visit.readings.back();
  for (int i = 0; i < 500; ++i) {
    visit.path.push_back(last);
    visit.readings.push_back(again);
  }
  EXPECT_EQ(map_of(visit).outline.outer, once.outline.outer);
}

}  // namespace
}  // namespace roomatlas
