// SPDX-License-Identifier: GPL-3.0-or-later
// The drafted plan as DXF, read back from the pairs of lines that the format consists of.
#include "draw/flat_fixture.hpp"
#include "io/store/store_samples.hpp"
#include "plans/dxf_doors.hpp"
#include "roomatlas/io/plans/ogr_export.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <set>
#include <sstream>

namespace roomatlas {
namespace {

using testing::ElementsAre;

struct Entity {
  std::string type;
  std::string layer;
  std::string text;
  std::string block;
  Polyline points;
};

std::vector<Entity> entities_of(const std::string& dxf) {
  std::istringstream stream(dxf.substr(dxf.find("ENTITIES")));
  std::vector<Entity> entities;
  std::string value;
  std::getline(stream, value);
  for (std::string code; std::getline(stream, code) && std::getline(stream, value);) {
    const int number = std::stoi(code);
    while (!value.empty() && (value.back() == '\r' || value.back() == ' ')) value.pop_back();
    if (number == 0 && value == "ENDSEC") break;
    if (number == 0) entities.push_back({value, "", "", "", {}});
    if (entities.empty()) continue;
    if (number == 8) entities.back().layer = value;
    if (number == 2) entities.back().block = value;
    if (number == 1) entities.back().text = value;
    if (number == 10) entities.back().points.emplace_back(std::stod(value), 0.0);
    if (number == 20) entities.back().points.back().y() = std::stod(value);
  }
  return entities;
}

class DxfOfAPlan : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_ogr()) GTEST_SKIP() << "a build without GDAL";
    write_dxf(folder_ / "plan.dxf", test::flat());
    entities_ = entities_of(bytes_of(folder_ / "plan.dxf"));
  }
  [[nodiscard]] std::vector<Entity> on(const std::string& layer) const {
    std::vector<Entity> found;
    for (const Entity& entity : entities_) {
      if (entity.layer == layer) found.push_back(entity);
    }
    return found;
  }
  TemporaryDirectory folder_;
  std::vector<Entity> entities_;
};

TEST_F(DxfOfAPlan, HasALayerForEachKindOfThing) {
  const std::map<std::string, std::size_t> expected = {
      {"A-WALL", 4}, {"A-WALL-MEAS", 9}, {"A-WALL-INFR", 2}, {"A-WALL-UNEX", 1},
      {"A-DOOR", 6}, {"A-GLAZ", 2},      {"A-DOOR-IDEN", 3}, {"A-GLAZ-IDEN", 1},
      {"A-FURN", 1}, {"A-FURN-FREE", 1}, {"A-AREA", 3},      {"A-AREA-IDEN", 6}};
  for (const auto& [layer, count] : expected) EXPECT_EQ(on(layer).size(), count) << layer;
}

TEST_F(DxfOfAPlan, AnInferredEdgeRunsWhereThePlanHasIt) {
  const std::vector<Entity> inferred = on("A-WALL-INFR");
  ASSERT_EQ(inferred.size(), 2U);
  ASSERT_EQ(inferred[0].points.size(), 2U);
  EXPECT_LT((inferred[0].points[0] - Point2(0.3, 3.3)).norm(), 1e-6);
  EXPECT_LT((inferred[0].points[1] - Point2(0.3, 0.3)).norm(), 1e-6);
}

TEST_F(DxfOfAPlan, DoorsAreInsertsOfBlocksByWhatIsKnownOfThem) {
  std::multiset<std::string> blocks;
  for (const char* layer : {"A-DOOR", "A-GLAZ"}) {
    for (const Entity& entity : on(layer)) {
      if (entity.type == "INSERT") blocks.insert(entity.block);
    }
  }
  EXPECT_THAT(blocks, ElementsAre("DOOR", "DOOR-80", "PASSAGE", "WINDOW"));
}

/// A point of a block where its INSERT puts it.
Point2 placed(const io::DoorSymbol& symbol, const Point2& at) {
  const double turn_rad = radians(symbol.turn_deg);
  const Point2 scaled(symbol.scale_x * at.x(), symbol.scale_y * at.y());
  return symbol.at + Point2(std::cos(turn_rad) * scaled.x() - std::sin(turn_rad) * scaled.y(),
                            std::sin(turn_rad) * scaled.x() + std::cos(turn_rad) * scaled.y());
}

TEST(DoorSymbols, TheArcGoesFromTheLeafToTheOtherJambHoweverTheDoorIsSaid) {
  const PlanDoor door = test::flat().doors[0];
  for (const bool is_swapped : {false, true}) {
    for (const double side : {1.0, -1.0}) {
      PlanDoor said = door;
      if (is_swapped) std::swap(said.jambs.a, said.jambs.b);
      said.leaf->b.y() = 3.42 + side * (door.leaf->b.y() - 3.42);
      const auto symbol = io::door_symbol(said);
      ASSERT_TRUE(symbol);
      const Polyline& leaf = symbol->block.lines[0];
      const Polyline& arc = symbol->block.lines[1];
      constexpr double kWholeDegrees_m = 0.015;  // half a degree, and a leaf as long as it is wide
      EXPECT_LT((placed(*symbol, leaf.front()) - said.leaf->a).norm(), 1e-9);
      EXPECT_LT((placed(*symbol, leaf.back()) - said.leaf->b).norm(), kWholeDegrees_m);
      EXPECT_LT((placed(*symbol, arc.front()) - said.leaf->b).norm(), kWholeDegrees_m);
      EXPECT_LT((placed(*symbol, arc.back()) - Point2(1.9, 3.42)).norm(), 1e-9);
      for (const Point2& point : arc) {
        EXPECT_NEAR((placed(*symbol, point) - said.leaf->a).norm(), 0.9, 1e-9);
      }
    }
  }
}

TEST_F(DxfOfAPlan, DimensionsAreLinesAndTextsThatAddUp) {
  std::vector<double> lengths;
  std::size_t lines = 0;
  for (const Entity& entity : on("A-ANNO-DIMS")) {
    if (entity.text.empty()) {
      ++lines;
    } else {
      lengths.push_back(std::stod(entity.text));
    }
  }
  // Below: five parts and their total, then the same on the left.
  ASSERT_EQ(lengths.size(), 12U);
  for (const std::size_t first : {0U, 6U}) {
    double sum = 0.0;
    for (std::size_t i = first; i < first + 5; ++i) sum += lengths[i];
    EXPECT_NEAR(sum, lengths[first + 5], 1e-9);
  }
  EXPECT_DOUBLE_EQ(lengths[5], 6.81);
  EXPECT_DOUBLE_EQ(lengths[11], 6.3);
  EXPECT_EQ(lines, 2U * ((1 + 2 * 6) + (1 + 2 * 2)));
}

}  // namespace
}  // namespace roomatlas
