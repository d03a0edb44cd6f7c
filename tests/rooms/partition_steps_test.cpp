// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of partition_rooms, each by a second route.
#include <gtest/gtest.h>

#include <algorithm>

#include "partition/cut_building.hpp"
#include "partition/region_graph.hpp"
#include "rooms/sketched_map.hpp"

namespace roomatlas {
namespace {

using test::SketchedMap;

OpenFloor floor_of(const SketchedMap& sketch, double cell_m = 0.05) {
  return open_floor(sketch.evidence(cell_m), {});
}

TEST(Flooded, KeepsPeaksApartThatADeepSaddleParts) {
  Raster<float> field({{0, 0}, {7, 1}});
  field.values = {1.0F, 3.0F, 1.0F, 0.5F, 1.0F, 2.0F, 1.0F};
  EXPECT_EQ(flooded(field, 0.2).values, (std::vector<std::int32_t>{1, 1, 1, 1, 1, 1, 1}));
  const Raster<std::int32_t> two = flooded(field, 0.9);
  EXPECT_EQ(two.values[0], two.values[2]);
  EXPECT_EQ(two.values[4], two.values[6]);
  EXPECT_NE(two.values[1], two.values[5]);
}

TEST(Flooded, DoesNotPassAtCorners) {
  Raster<float> field({{0, 0}, {2, 2}});
  field.values = {1.0F, 0.0F, 0.0F, 1.0F};
  EXPECT_EQ(flooded(field, 0.5).values, (std::vector<std::int32_t>{1, 0, 0, 2}));
}

TEST(IslandsFilled, FillsWhatFitsIntoASquareHoweverItIsTurned) {
  SketchedMap sketch = SketchedMap().floor(0, 0, 10, 10).obstacle(4, 4, 5.1, 5.1);
  sketch.obstacle(7, 7, 7.2, 9);  // too long
  for (const double angle_deg : {0.0, 20.0, 45.0}) {
    const PartitionEvidence map = sketch.evidence(0.05, radians(angle_deg));
    const CellMask filled = islands_filled(map.free, map.frame, 1.2);
    const auto filled_at = [&](const Point2& at) {
      return filled.at(map.frame.cell_of(Pose2{0, 0, radians(angle_deg)} * at));
    };
    EXPECT_TRUE(filled_at({4.5, 4.5})) << angle_deg;
    EXPECT_FALSE(filled_at({7.1, 8.0})) << angle_deg;
    EXPECT_FALSE(filled_at({-0.2, 5.0})) << "walls stay";
  }
}

TEST(WallDirections, AreFoundInTurnedMaps) {
  for (const double turned_deg : {0.0, 10.0, 30.0, 80.0}) {
    const OpenFloor floor =
        open_floor(SketchedMap().floor(0, 0, 9, 6).evidence(0.05, radians(turned_deg)), {});
    const std::vector<FloorSide> faces = find_floor_sides(floor);
    ASSERT_FALSE(faces.empty());
    for (const FloorSide& face : faces) {
      EXPECT_NEAR(wrap_quarter(face.heading_rad - radians(turned_deg)), 0.0, radians(0.7));
    }
  }
}

TEST(WallSupport, CountsWallsBesideFloorAndNotBlocks) {
  // a thin wall along y = 2 from x = 3 on; below it a block of 2 m
  SketchedMap sketch = SketchedMap().floor(0, 0, 6, 4).obstacle(3, 1.95, 6, 2.05);
  const OpenFloor floor = floor_of(sketch);
  const WallSupport wall = wall_support(floor, {3.0, 2.0}, {1, 0});
  EXPECT_NEAR(wall.near, 1.0, 1e-9);
  EXPECT_NEAR(wall.far, 1.0, 1e-9);
  const WallSupport none = wall_support(floor, {3.0, 2.0}, {-1, 0});
  EXPECT_LT(none.far, 0.1);
  const OpenFloor block = floor_of(SketchedMap().floor(0, 0, 2, 4).floor(2, 0, 6, 0.5));
  EXPECT_LT(wall_support(block, {2.0, 2.0}, {1, 0}).far, 0.3) << "the middle of a block";
}

TEST(PassageAt, TellsCorridorsMouthsAndDoors) {
  SketchedMap sketch = SketchedMap().floor(0, 0, 6, 6).floor(6, 2, 14, 4);
  sketch.floor(6.2, 4.3, 14, 8).floor(9, 3.9, 10, 4.4);
  const OpenFloor floor = floor_of(sketch);
  const Passage across = passage_at(floor, {{12.4, 2}, {12.4, 4}});
  EXPECT_GT(across.less, 0.9);
  EXPECT_TRUE(is_across_corridor(across));
  const Passage mouth = passage_at(floor, {{6, 2}, {6, 4}});
  EXPECT_LT(mouth.less, 0.01);
  EXPECT_GT(mouth.more, 0.9);
  EXPECT_GT(mouth.rise, 0.7) << "into a hall";
  const Passage door = passage_at(floor, {{9, 4.1}, {10, 4.1}});
  EXPECT_LT(door.more, 0.01);
  EXPECT_FALSE(is_across_corridor(door));
}

TEST(FindWallChords, CloseADoorInLineWithItsWall) {
  const OpenFloor floor = floor_of(test::two_room_map());
  const std::vector<WallChord> chords = find_wall_chords(floor, find_floor_sides(floor), {});
  ASSERT_FALSE(chords.empty());
  for (const WallChord& chord : chords) {
    EXPECT_NEAR(chord.length_m(), 0.9, 0.1);
    EXPECT_NEAR(chord.line.a.x(), 4.1, 0.15);
    EXPECT_NEAR(chord.line.b.x(), 4.1, 0.15);
  }
}

TEST(CutFloor, EveryOpenCellIsInOnePiece) {
  const CutBuilding cut = cut_building(test::corridor_map().evidence(0.05, 0.4), {});
  for (std::size_t i = 0; i < cut.floor.open.bits.size(); ++i) {
    EXPECT_EQ(cut.pieces.piece_of_cell.values[i] != 0, cut.floor.open.bits[i] != 0);
  }
}

TEST(RegionGraph, JoiningAddsAreasAndOpenings) {
  const CutBuilding cut = cut_building(test::corridor_map().evidence(), {});
  RegionGraph graph(cut.pieces, cut.floor.frame, cut.openings);
  const auto total_m2 = [&] {
    double sum = 0.0;
    for (const std::int32_t region : graph.regions()) sum += graph.region(region).area_m2;
    return sum;
  };
  const double before_m2 = total_m2();
  EXPECT_NEAR(before_m2, static_cast<double>(cut.floor.open.count()) * 0.0025, 1e-6);
  while (!graph.pairs().empty()) {
    const std::size_t regions = graph.regions().size();
    const RegionGraph::Pair pair = graph.pairs().front();
    const std::int32_t kept = graph.join(pair);
    EXPECT_EQ(graph.regions().size(), regions - 1);
    EXPECT_EQ(graph.region_of(pair.first), kept);
    EXPECT_EQ(graph.region_of(pair.second), kept);
    EXPECT_GE(graph.region(kept).hull_m2, graph.region(kept).area_m2 - 1e-6);
  }
  EXPECT_EQ(graph.regions().size(), 1U);
  EXPECT_NEAR(total_m2(), before_m2, 1e-6);
}

TEST(DoorProbability, IsTheLogisticFunctionOfItsExponent) {
  DoorWeights model;
  model.bias = 0.5;
  model.weights[2] = -2.0;
  DoorFigures figures{};
  figures[2] = 1.0;
  EXPECT_NEAR(door_probability(figures, model), 1.0 / (1.0 + std::exp(1.5)), 1e-12);
  EXPECT_LT(door_probability(figures, model, 1.0), door_probability(figures, model));
}

}  // namespace
}  // namespace roomatlas
