// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/plan_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include "roomatlas/core/issue.hpp"

namespace roomatlas {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// The message that reading the text ends with.
std::string refusal_of(const std::string& text) {
  try {
    (void)testing_io::read_plan_text(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

constexpr const char* kWall =
    R"({"type":"Feature","properties":{"kind":"wall"},
        "geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,0]]]}},)";

/// A sound wall, then a feature with these properties and geometry.
std::string second_feature(const std::string& properties, const std::string& geometry) {
  return testing_io::collection(std::string(kWall) + R"({"type":"Feature","properties":)" +
                                properties + R"(,"geometry":)" + geometry + "}");
}

std::string polygon(const std::string& coordinates) {
  return R"({"type":"Polygon","coordinates":)" + coordinates + "}";
}

const std::string kTriangle = polygon("[[[0,0],[1,0],[1,1],[0,0]]]");

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  return text.replace(text.find(what), what.size(), with);
}

TEST(PlanGeojsonErrors, AMissingFileIsNamed) {
  EXPECT_THROW((void)read_plan("no/such/plan.geojson"), InputError);
  EXPECT_THROW((void)read_plan(testing::TempDir()), InputError);
}

TEST(PlanGeojsonErrors, BadJsonIsNamedWithItsPlace) {
  EXPECT_THAT(refusal_of("{\n\"type\": oops}"),
              AllOf(HasSubstr("plan.geojson: not valid JSON"), HasSubstr("line 2")));
  EXPECT_THAT(refusal_of(""), HasSubstr("not valid JSON"));
  EXPECT_THAT(refusal_of("[1, 2]"), HasSubstr("expected an object"));
  EXPECT_THAT(refusal_of(second_feature(R"({"kind":"wall"})", polygon("[[[1e999,0]]]"))),
              HasSubstr("not valid JSON"));
}

TEST(PlanGeojsonErrors, AnUnknownWordForAnOpeningOrAPieceOfFurnitureIsRefused) {
  EXPECT_THAT(refusal_of(second_feature(
                  R"({"kind":"door","id":1,"jambs":[[0,0],[1,0]],"opening":"hole"})", "null")),
              AllOf(HasSubstr("features[1].properties.opening"), HasSubstr("\"window\"")));
  EXPECT_THAT(refusal_of(second_feature(
                  R"({"kind":"door","id":1,"jambs":[[0,0],[1,0]],"leaf":[[0,0]]})", "null")),
              AllOf(HasSubstr("features[1].properties.leaf"), HasSubstr("two positions")));
  EXPECT_THAT(refusal_of(second_feature(R"({"kind":"furniture","furniture":"soft"})", kTriangle)),
              AllOf(HasSubstr("features[1].properties.furniture"), HasSubstr("\"free_standing\"")));
}

TEST(PlanGeojsonErrors, AForeignHeaderIsRefused) {
  const std::string sound = testing_io::collection("");
  EXPECT_EQ(refusal_of(sound), "no error");
  EXPECT_THAT(refusal_of(R"({"type":"FeatureCollection","features":[]})"),
              HasSubstr("roomatlas: missing"));
  EXPECT_THAT(refusal_of(replaced(sound, "\"m\"", "\"ft\"")),
              HasSubstr("roomatlas.units: expected \"m\""));
  EXPECT_THAT(refusal_of(replaced(sound, "\"m\"", "\"ft\"")), HasSubstr("found \"ft\""));
  EXPECT_THAT(refusal_of(replaced(sound, "\"plan\"", "\"route\"")), HasSubstr("roomatlas.schema"));
  EXPECT_THAT(refusal_of(replaced(sound, "1,", "2,")), HasSubstr("roomatlas.version"));
  EXPECT_THAT(refusal_of(replaced(sound, "FeatureCollection", "Feature")),
              HasSubstr("type: expected \"FeatureCollection\", found \"Feature\""));
}

TEST(PlanGeojsonErrors, AnUnknownKindIsNamedWithItsFeature) {
  EXPECT_THAT(refusal_of(second_feature(R"({"kind":"stairs"})", kTriangle)),
              AllOf(HasSubstr("plan.geojson: features[1].properties.kind: expected"),
                    HasSubstr("found \"stairs\"")));
  EXPECT_THAT(refusal_of(second_feature("{}", kTriangle)),
              HasSubstr("features[1].properties.kind: missing"));
  EXPECT_THAT(refusal_of(second_feature("null", kTriangle)),
              HasSubstr("features[1].properties: expected an object, found null"));
}

TEST(PlanGeojsonErrors, ABadPropertyIsNamed) {
  const auto room = [](const std::string& more) {
    return refusal_of(second_feature(R"({"kind":"room",)" + more + "}", kTriangle));
  };
  EXPECT_EQ(room(R"("id":1)"), "no error");
  EXPECT_THAT(room(R"("name":"x")"), HasSubstr("features[1].properties.id: missing"));
  EXPECT_THAT(room(R"("id":"one")"), HasSubstr("properties.id: expected a whole number >= 1"));
  EXPECT_THAT(room(R"("id":-3)"), HasSubstr("properties.id: expected a whole number >= 1"));
  EXPECT_THAT(room(R"("id":1,"name":5)"), HasSubstr("properties.name: expected a text, found 5"));
  EXPECT_THAT(room(R"("id":1,"area_m2":-2)"), HasSubstr("properties.area_m2"));
  EXPECT_THAT(room(R"("id":1,"label":[1])"), HasSubstr("properties.label: expected a position"));
  EXPECT_THAT(room(R"("id":1,"asrs":[1,"b"])"), HasSubstr("properties.asrs[1]"));
}

TEST(PlanGeojsonErrors, ABadDoorIsNamed) {
  const auto door = [](const std::string& more) {
    return refusal_of(second_feature(R"({"kind":"door","id":1,)" + more + "}", kTriangle));
  };
  EXPECT_EQ(door(R"("jambs":[[0,0],[0,1]])"), "no error");
  EXPECT_THAT(door(R"("width_m":1)"), HasSubstr("properties.jambs: missing"));
  EXPECT_THAT(door(R"("jambs":[[0,0]])"), HasSubstr("properties.jambs: expected two positions"));
  EXPECT_THAT(door(R"("jambs":[[0,0],[0,1]],"width_m":"wide")"),
              HasSubstr("properties.width_m: expected a finite number, found \"wide\""));
  EXPECT_THAT(door(R"("jambs":[[0,0],[0,1]],"rooms":[1])"), HasSubstr("properties.rooms"));
  EXPECT_THAT(door(R"("jambs":[[0,0],[0,1]],"rooms":[1,1])"), HasSubstr("two different rooms"));
  EXPECT_THAT(door(R"("jambs":[[0,0],[0,1]],"rooms":[1,null])"),
              HasSubstr("door 1 leads to room 1, which is not in the file"));
}

TEST(PlanGeojsonErrors, ABadGeometryIsNamed) {
  const auto wall = [](const std::string& geometry) {
    return refusal_of(second_feature(R"({"kind":"wall"})", geometry));
  };
  EXPECT_EQ(wall(kTriangle), "no error");
  EXPECT_THAT(wall("null"), HasSubstr("features[1].geometry: expected an object, found null"));
  EXPECT_THAT(wall(R"({"type":"Polygon"})"), HasSubstr("geometry.coordinates: missing"));
  EXPECT_THAT(wall(R"({"type":"Point","coordinates":[0,0]})"),
              HasSubstr("geometry.type: expected \"Polygon\", found \"Point\""));
  EXPECT_THAT(wall(polygon("[]")), HasSubstr("at least one ring"));
  EXPECT_THAT(wall(polygon("[[]]")), HasSubstr("a closed ring"));
  EXPECT_THAT(wall(polygon("[[[0,0],[1,0],[1,1]]]")), HasSubstr("a closed ring"));
  EXPECT_THAT(wall(polygon("[[[0,0],[1,0],[0,0]]]")),
              HasSubstr("geometry.coordinates[0]: expected a ring of at least three"));
  EXPECT_THAT(wall(polygon("[[[0,0],[1],[1,1],[0,0]]]")),
              HasSubstr("geometry.coordinates[0][1]: expected a position [x, y], found [1]"));
  EXPECT_THAT(wall(polygon("[[[0,0],[1,null],[1,1],[0,0]]]")),
              HasSubstr("coordinates[0][1][1]: expected a finite number, found null"));
}

TEST(PlanGeojsonErrors, IdsThatOccurTwiceAreRefused) {
  const std::string room =
      R"({"type":"Feature","properties":{"kind":"room","id":3},"geometry":)" + kTriangle + "}";
  EXPECT_THAT(refusal_of(testing_io::collection(room + "," + room)),
              HasSubstr("two rooms have the id 3"));
}

}  // namespace
}  // namespace roomatlas
