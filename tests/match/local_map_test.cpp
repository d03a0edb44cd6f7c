// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/match/local_map.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "match/swept_room.hpp"
#include "roomatlas/grid/himm_grid.hpp"

namespace roomatlas {
namespace {

using Key = std::pair<int, int>;

TEST(LocalMap, KeepsTheTwoFacesOfAThinWallApart) {
  // both faces lie in one row of cells
  const std::vector<Segment2> surfaces = {{{-3.0, 2.02}, {3.0, 2.02}}, {{3.0, 2.08}, {-3.0, 2.08}}};
  LocalMap map(0.1);
  for (const double y : {1.0, 3.0}) {
    const auto readings = test::readings_along(surfaces, {{-1.0, y}, {1.0, y}});
    for (const RangeReading& reading : readings) {
      map.add(scan_of(reading, {}), reading.odom_from_robot);
    }
  }
  std::map<Key, std::set<double>> sides;  // of each cell
  for (const Face& face : map.faces(2.0)) {
    if (std::abs(face.position.x()) > 1.5) continue;  // seen at a flat angle
    const double side = face.normal.y() < 0.0 ? -1.0 : 1.0;
    EXPECT_NEAR(face.position.y(), side < 0.0 ? 2.02 : 2.08, 1e-3);
    EXPECT_NEAR(face.normal.y(), side, 1e-2);
    const Cell cell = map.frame().cell_of(face.position);
    sides[{cell.x, cell.y}].insert(side);
  }
  EXPECT_GE(sides.size(), 28U);
  for (const auto& [cell, found] : sides) EXPECT_EQ(found.size(), 2U) << cell.first;
}

TEST(LocalMap, AFaceIsTheMeanOfItsHits) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  std::uniform_real_distribution<double> wobble(-0.4, 0.4);
  struct Sum {
    Point2 position = Point2::Zero();
    Point2 normal = Point2::Zero();
    double hits = 0.0;
  };
  std::map<Key, Sum> sums;
  LocalMap map(0.1);
  for (int i = 0; i < 3000; ++i) {
    const Pose2 map_from_robot{coordinate(random), coordinate(random), 3.0 * coordinate(random)};
    const Point2 position(coordinate(random), coordinate(random));
    const Point2 normal = direction(1.0 + wobble(random));
    map.add({{0.0, 0.0}, test::seen_from(map_from_robot, {{position, normal, true}})},
            map_from_robot);
    const Cell cell = map.frame().cell_of(position);
    Sum& sum = sums[{cell.x, cell.y}];
    sum.position += position;
    sum.normal += normal;
    sum.hits += 1.0;
  }
  const std::vector<Face> faces = map.faces(0.0);
  ASSERT_EQ(faces.size(), sums.size());
  for (const Face& face : faces) {
    const Cell cell = map.frame().cell_of(face.position);
    const Sum& sum = sums.at({cell.x, cell.y});
    ASSERT_LT(sum.hits, 40.0);
    EXPECT_EQ(face.hits, sum.hits);
    EXPECT_LT((face.position - sum.position / sum.hits).norm(), 1e-9);
    EXPECT_LT((face.normal - sum.normal.normalized()).norm(), 1e-9);
  }
  EXPECT_LT(map.faces(8.0).size(), faces.size());
  for (const Face& face : map.faces(8.0)) EXPECT_GE(face.hits, 8.0);
}

TEST(LocalMap, AFaceThatWasHitOftenFollowsWhatIsSeenNow) {
  LocalMap map(0.1);
  const auto hit = [&](double x, int times) {
    for (int i = 0; i < times; ++i) {
      map.add({{x, 0.05}, {{{x, 0.05}, Point2::UnitY(), true}}}, {});
    }
  };
  hit(0.01, 1000);
  hit(0.09, 100);
  ASSERT_EQ(map.faces(0.0).size(), 1U);
  EXPECT_GT(map.faces(0.0)[0].position.x(), 0.08);  // the plain mean is 0.017
}

TEST(LocalMap, AFaceOfWhichFewHitsHaveADirectionHasNone) {
  LocalMap map(0.1);
  for (const double angle_deg : {0.0, 80.0}) {
    map.add({{0.0, 0.0}, {{{0.05, 0.05}, direction(radians(angle_deg)), true}}}, {});
  }
  for (int i = 0; i < 5; ++i) {
    map.add({{0.0, 0.0}, {{{0.05, 0.05}, Point2::Zero(), true}}}, {});
  }
  const std::vector<Face> faces = map.faces(0.0);
  ASSERT_EQ(faces.size(), 1U);
  EXPECT_EQ(faces[0].normal, Point2::Zero());
}

TEST(LocalMap, CertaintyIsThatOfTheHimmGrid) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-4.0, 4.0);
  LocalMap map(0.1);
  HimmGrid grid(0.1);
  for (int sweep = 0; sweep < 40; ++sweep) {
    const Pose2 map_from_robot{coordinate(random), coordinate(random), coordinate(random)};
    Scan scan;
    scan.sensor = {0.1, -0.05};
    std::vector<Ray> rays;
    for (int i = 0; i < 30; ++i) {
      scan.points.push_back({{coordinate(random), coordinate(random)}, Point2::Zero(), true});
      rays.push_back(
          {{map_from_robot * scan.sensor, map_from_robot * scan.points.back().position}, true});
    }
    map.add(scan, map_from_robot);
    grid.add_sweep(rays);
  }
  int free = 0;
  for_each_cell({{-120, -120}, {120, 120}}, [&](const Cell& cell) {
    ASSERT_EQ(map.certainty(cell), grid.raw(cell)) << cell.x << " " << cell.y;
    EXPECT_EQ(map.is_seen_free(cell), grid.value(cell) <= -1.0);
    free += map.is_seen_free(cell) ? 1 : 0;
  });
  EXPECT_GT(free, 1000);
}

TEST(LocalMap, VisitsAllFacesNearAPoint) {
  const LocalMap map = test::map_of(test::readings_in(test::kUnevenRoom));
  std::mt19937 random(9);
  std::uniform_real_distribution<double> x(0.0, 8.4);
  std::uniform_real_distribution<double> y(0.0, 4.5);
  std::size_t near = 0;
  for (int i = 0; i < 300; ++i) {
    const Point2 at(x(random), y(random));
    const double radius_m = 0.02 + 0.001 * i;
    std::multiset<std::pair<double, double>> visited;
    map.for_each_face_near(at, radius_m, [&](const Face& face) {
      visited.insert({face.position.x(), face.position.y()});
    });
    for (const Face& face : map.faces(0.0)) {
      if ((face.position - at).norm() > radius_m) continue;
      ++near;
      EXPECT_EQ(visited.count({face.position.x(), face.position.y()}), 1U);
    }
  }
  EXPECT_GT(near, 100U);
}

TEST(LocalMap, KnownCellsAreFreeOrHoldAFace) {
  const LocalMap map = test::map_of(test::readings_in(test::kUnevenRoom));
  std::set<Key> with_face;
  for (const Face& face : map.faces(2.0)) {
    const Cell cell = map.frame().cell_of(face.position);
    with_face.insert({cell.x, cell.y});
  }
  std::set<Key> free;
  std::set<Key> faces;
  map.for_each_known_cell(
      2.0,
      [&](const Cell& cell) {
        EXPECT_TRUE(free.insert({cell.x, cell.y}).second);
      },
      [&](const Cell& cell) {
        EXPECT_TRUE(faces.insert({cell.x, cell.y}).second);
      });
  EXPECT_EQ(faces, with_face);
  for_each_cell(map.box(), [&](const Cell& cell) {
    EXPECT_EQ(free.count({cell.x, cell.y}) > 0, map.is_seen_free(cell));
  });
}

}  // namespace
}  // namespace roomatlas
