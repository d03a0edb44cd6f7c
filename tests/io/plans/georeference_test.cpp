// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/plans/georeference.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "roomatlas/core/pose2.hpp"

namespace roomatlas {
namespace {

using Json = nlohmann::json;
using Eigen::Vector3d;

constexpr double kSemiMajor_m = 6378137.0;
constexpr double kEccentricity2 = 6.69437999014e-3;

Vector3d earth_centred(const GeoPosition& at) {
  const double lat = radians(at.latitude_deg);
  const double lon = radians(at.longitude_deg);
  const double n = kSemiMajor_m / std::sqrt(1.0 - kEccentricity2 * std::pow(std::sin(lat), 2));
  return {n * std::cos(lat) * std::cos(lon), n * std::cos(lat) * std::sin(lon),
          n * (1.0 - kEccentricity2) * std::sin(lat)};
}

/// East and north of `at` seen from the reference, by way of earth-centred coordinates.
Point2 east_north(const GeoReference& from, const GeoPosition& at) {
  const double lat = radians(from.latitude_deg);
  const double lon = radians(from.longitude_deg);
  const Vector3d d = earth_centred(at) - earth_centred({from.latitude_deg, from.longitude_deg});
  const Vector3d east(-std::sin(lon), std::cos(lon), 0.0);
  const Vector3d north(-std::sin(lat) * std::cos(lon), -std::sin(lat) * std::sin(lon),
                       std::cos(lat));
  return {east.dot(d), north.dot(d)};
}

TEST(GeoReference, PutsPointsWhereEarthCentredCoordinatesSay) {
  for (const double latitude : {-33.0, 0.0, 48.01, 60.0}) {
    const GeoReference reference{latitude, 7.83, 0.0};
    const Point2 back = east_north(reference, position_on_earth(reference, {70.0, -70.0}));
    EXPECT_NEAR(back.x(), 70.0, 2e-3) << latitude;
    EXPECT_NEAR(back.y(), -70.0, 2e-3) << latitude;
  }
}

TEST(GeoReference, HeadingIsTheCompassDirectionOfTheYAxis) {
  const GeoReference reference{48.0, 7.8, 90.0};
  const Point2 up = east_north(reference, position_on_earth(reference, {0.0, 10.0}));
  EXPECT_NEAR(up.x(), 10.0, 1e-3);
  EXPECT_NEAR(up.y(), 0.0, 1e-3);
}

TEST(GeoReference, GivesGeoJsonWithIndoorTagsAndCounterClockwiseRings) {
  FloorPlan plan;
  plan.rooms = {
      {4, "Lab", RoomKind::corridor, {{{{0, 0}, {4, 0}, {4, 3}, {0, 3}}, {}}}, 12.0, {1, 1}, {}}};
  plan.doors = {{1, {{4, 1}, {4, 2}}, 1.0, {}, 4, std::nullopt}};
  plan.walls = {{{{4, 0}, {4.2, 0}, {4.2, 3}, {4, 3}}, {}}};
  const Json json = Json::parse(to_geojson(plan, {48.0, 7.8, 30.0}));
  const Json& features = json["features"];
  ASSERT_EQ(features.size(), 3U);
  EXPECT_EQ(features[0]["properties"]["indoor"], "corridor");
  EXPECT_EQ(features[0]["properties"]["name"], "Lab");
  EXPECT_EQ(features[0]["properties"]["level"], "0");
  EXPECT_EQ(features[1]["properties"]["indoor"], "door");
  EXPECT_EQ(features[1]["geometry"]["type"], "Point");
  EXPECT_EQ(features[2]["properties"]["indoor"], "wall");
  const Json& ring = features[0]["geometry"]["coordinates"][0];
  EXPECT_EQ(ring.front(), ring.back());
  double twice_area = 0.0;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
    const double x = ring[i][0].get<double>() - 7.8;
    const double y = ring[i][1].get<double>() - 48.0;
    EXPECT_LT(std::abs(x) + std::abs(y), 1e-3);  // longitude first
    twice_area +=
        x * (ring[i + 1][1].get<double>() - 48.0) - (ring[i + 1][0].get<double>() - 7.8) * y;
  }
  EXPECT_GT(twice_area, 0.0);
}

}  // namespace
}  // namespace roomatlas
