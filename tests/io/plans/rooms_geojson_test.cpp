// SPDX-License-Identifier: GPL-3.0-or-later
// Rooms as other programs write them: QGIS in metres, OpenStreetMap in longitude and latitude.
#include "roomatlas/io/plans/rooms_geojson.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/plans/georeference.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace roomatlas {
namespace {

using ::testing::HasSubstr;

class RoomsGeojson : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = Path(testing::TempDir()) / (std::string("roomatlas_rooms_") + test->name());
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  FloorPlan read(const std::string& text) const {
    std::ofstream(folder_ / "rooms.geojson", std::ios::binary) << text;
    return read_any_plan(folder_ / "rooms.geojson");
  }
  std::string complaint(const std::string& text) const {
    try {
      (void)read(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing was wrong";
  }

  Path folder_;
};

std::string collection(const std::string& features, const std::string& more = "") {
  return R"({"type":"FeatureCollection",)" + more + R"("features":[)" + features + "]}";
}
std::string feature(const std::string& type, const std::string& coordinates,
                    const std::string& properties) {
  return R"({"type":"Feature","properties":)" + properties + R"(,"geometry":{"type":")" + type +
         R"(","coordinates":)" + coordinates + "}}";
}
std::string room(double x, double y, double wide, double deep, const std::string& properties) {
  std::ostringstream ring;
  ring.precision(12);
  ring << "[[[" << x << "," << y << "],[" << x + wide << "," << y << "],[" << x + wide << ","
       << y + deep << "],[" << x << "," << y + deep << "],[" << x << "," << y << "]]]";
  return feature("Polygon", ring.str(), properties);
}

std::string text_of(const Issues& issues) {
  std::string text;
  for (const Issue& issue : issues) text += to_string(issue) + "\n";
  return text;
}

bool is_in_wall(const FloorPlan& plan, const Point2& at) {
  for (const Polygon& wall : plan.walls) {
    if (contains(wall, at)) return true;
  }
  return false;
}

/// Two rooms that touch and a third behind a wall of 0.2 m; a door each.
const std::string kThreeRooms =
    room(0, 0, 4, 4, R"({"Name":"Kitchen","room":"kitchen"})") + "," +
    room(4, 0, 4, 4, R"({"ref":12,"indoor":"corridor"})") + "," + room(8.2, 0, 4, 4, "{}") + "," +
    feature("Point", "[4,2]", R"({"door":"hinged","width":"1.0 m"})") + "," +
    feature("LineString", "[[8.1,1],[8.1,1.8]]", R"({"indoor":"door"})") + "," +
    feature("Point", "[1,1]", R"({"amenity":"bench"})");

TEST_F(RoomsGeojson, InMetresGiveRoomsDoorsAndWallsWithGaps) {
  const FloorPlan plan = read(collection(kThreeRooms));
  ASSERT_EQ(plan.rooms.size(), 3U);
  EXPECT_EQ(plan.rooms[0].name, "Kitchen");
  EXPECT_EQ(plan.rooms[1].name, "12");
  EXPECT_EQ(plan.rooms[2].name, "3");
  EXPECT_EQ(plan.rooms[1].kind, RoomKind::corridor);
  EXPECT_NEAR(plan.rooms[2].area_m2, 16.0, 1e-9);
  ASSERT_EQ(plan.doors.size(), 2U);
  EXPECT_EQ(plan.doors[0].room_a, 1);
  EXPECT_EQ(plan.doors[0].room_b, 2);
  EXPECT_NEAR(plan.doors[0].width_m, 1.0, 1e-9);
  EXPECT_EQ(plan.doors[1].room_a, 2);
  EXPECT_EQ(plan.doors[1].room_b, 3);
  EXPECT_NEAR(plan.doors[1].width_m, 0.8, 1e-9);
  EXPECT_THAT(text_of(plan.issues), HasSubstr("1 feature left out"));

  // Along every edge there is wall, but in the doors: by points, a centimetre apart.
  for (const PlanRoom& one : plan.rooms) {
    const Ring& ring = one.parts[0].outer;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point2 a = ring[i];
      const Point2 b = ring[(i + 1) % ring.size()];
      for (double share = 0.0; share < 1.0; share += 0.0025) {
        const Point2 at = a + share * (b - a);
        const bool in_first = std::abs(at.x() - 4.0) < 0.1 && std::abs(at.y() - 2.0) < 0.5;
        const bool in_second = std::abs(at.x() - 8.1) < 0.15 && std::abs(at.y() - 1.4) < 0.4;
        const bool at_jamb = std::abs(std::abs(at.y() - 2.0) - 0.5) < 0.03 ||
                             std::abs(std::abs(at.y() - 1.4) - 0.4) < 0.03;
        if (at_jamb) continue;
        EXPECT_EQ(is_in_wall(plan, at), !in_first && !in_second) << at.transpose();
      }
    }
  }
  // The doorway through the thick wall has sides: one cannot look into the wall.
  EXPECT_TRUE(is_in_wall(plan, {8.1, 1.0}));
  EXPECT_TRUE(is_in_wall(plan, {8.1, 1.8}));
  EXPECT_FALSE(is_in_wall(plan, {8.1, 1.4}));
}

/// Distances between all corners, by which two layouts are the same but for their place.
std::vector<double> distances(const FloorPlan& plan) {
  std::vector<Point2> corners;
  for (const PlanRoom& one : plan.rooms) {
    corners.insert(corners.end(), one.parts[0].outer.begin(), one.parts[0].outer.end());
  }
  std::vector<double> all;
  for (const Point2& a : corners) {
    for (const Point2& b : corners) all.push_back((a - b).norm());
  }
  return all;
}

TEST_F(RoomsGeojson, OnTheEarthAreLaidOutInMetres) {
  const FloorPlan plan = read_plan(Path(ROOMATLAS_SOURCE_DIR) / "data/worlds/eight_rooms.geojson");
  const FloorPlan back = read(to_geojson(plan, {48.013, 7.8335, 30.0}));
  ASSERT_EQ(back.rooms.size(), plan.rooms.size());
  EXPECT_EQ(back.doors.size(), plan.doors.size());
  EXPECT_THAT(text_of(back.issues), HasSubstr("longitude and latitude"));
  const std::vector<double> before = distances(plan);
  const std::vector<double> after = distances(back);
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(before[i], after[i], 0.005);
}

TEST_F(RoomsGeojson, FarFromTheirOriginAreMovedNear) {
  const FloorPlan plan = read(collection(room(412345.5, 5312345.5, 4, 5, "{}")));
  EXPECT_LT(plan.rooms[0].parts[0].outer[0].norm(), 2.0);
  EXPECT_NEAR(plan.rooms[0].area_m2, 20.0, 1e-6);
  EXPECT_THAT(text_of(plan.issues), HasSubstr("412345 east and 5312345 north are taken off"));
}

TEST_F(RoomsGeojson, ThatTellNoBuildingAreRefused) {
  EXPECT_THAT(complaint(collection(feature("Point", "[1,1]", "{}"))), HasSubstr("no polygon"));
  EXPECT_THAT(complaint(collection(room(0, 0, 4, 4, R"({"level":"0"})") + "," +
                                   room(0, 0, 4, 4, R"({"level":"1"})"))),
              HasSubstr("rooms of 2 levels (0, 1), expected one"));
  EXPECT_THAT(complaint(collection(
                  room(0, 0, 4, 4, "{}"),
                  R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::3857"}},)")),
              HasSubstr("Web Mercator"));
  EXPECT_THAT(complaint(collection(feature("Polygon", "[[[0,0],[1,0]]]", "{}"))),
              HasSubstr("features[0].geometry"));
  EXPECT_THAT(complaint(R"({"type":"FeatureCollection"})"), HasSubstr("features: expected a list"));
}

TEST_F(RoomsGeojson, WithNumbersThatCannotBeMeantAreRefusedOrTakenAsUsual) {
  const std::string two = room(0, 0, 4, 4, "{}") + "," + room(4, 0, 4, 4, "{}") + ",";
  const FloorPlan plan =
      read(collection(two + feature("Point", "[4,2]", R"({"door":"yes","width":"1e-320 m"})")));
  ASSERT_EQ(plan.doors.size(), 1U);
  EXPECT_NEAR(plan.doors[0].width_m, 0.9, 1e-9);
  EXPECT_THAT(complaint(collection(two + feature("Point", "[4,1e300]", R"({"door":"yes"})"))),
              HasSubstr("coordinates: expected places within 100,000 km"));
  EXPECT_THAT(complaint(collection(room(0, 0, 1e12, 4, "{}"))), HasSubstr("100,000 km"));
}

TEST_F(RoomsGeojson, WithoutDoorsSaySo) {
  const FloorPlan plan = read(collection(room(0, 0, 4, 4, "{}") + "," + room(5, 0, 4, 4, "{}")));
  EXPECT_TRUE(plan.doors.empty());
  EXPECT_THAT(text_of(plan.issues), HasSubstr("the file shows none"));
}

TEST_F(RoomsGeojson, OfThisProgramAreReadAsEver) {
  const Path file = Path(ROOMATLAS_SOURCE_DIR) / "data/worlds/two_rooms.geojson";
  EXPECT_EQ(to_geojson(read_any_plan(file)), to_geojson(read_plan(file)));
}

}  // namespace
}  // namespace roomatlas
