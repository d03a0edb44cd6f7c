// SPDX-License-Identifier: GPL-3.0-or-later
// Columns stand in rows; what stands alone, unevenly or askew is furniture.
#include "roomatlas/draft/columns.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "known_poses.hpp"

namespace roomatlas {
namespace {

constexpr double kStep_m = 0.02;  // between surfaces

/// What stands in a room, as find_furniture and lasers see it.
struct Scene {
  std::vector<PlanFurniture> pieces;
  std::vector<SurfacePoint> surfaces;

  void add(Ring outline) {
    pieces.push_back({{std::move(outline), {}}, FurnitureKind::free_standing});
  }

  void add_box(const Pose2& place, double length_m, double width_m) {
    const Point2 half(length_m / 2.0, width_m / 2.0);
    Ring box = {-half, {half.x(), -half.y()}, half, {-half.x(), half.y()}};
    for (Point2& corner : box) corner = place * corner;
    for (std::size_t i = 0; i < 4; ++i) {
      const Point2 way = box[(i + 1) % 4] - box[i];
      const double normal_rad = std::atan2(way.y(), way.x()) - kPi / 2.0;
      for (double at_m = kStep_m; at_m < way.norm(); at_m += kStep_m) {
        surfaces.push_back({box[i] + at_m * way.normalized(), normal_rad, 1.0});
      }
    }
    add(box);
  }

  void add_disc(const Point2& middle, double radius_m) {
    Ring ring;
    const int count = static_cast<int>(2.0 * kPi * radius_m / kStep_m);
    for (int i = 0; i < count; ++i) {
      const double angle_rad = wrap_angle(2.0 * kPi * i / count);
      ring.push_back(middle + radius_m * direction(angle_rad));
      surfaces.push_back({ring.back(), angle_rad, 1.0});
    }
    add(ring);
  }

  [[nodiscard]] std::vector<Ring> columns() const { return find_columns(pieces, surfaces, {}); }
};

const Pose2 kTurned{3.0, -2.0, radians(17.0)};

Scene row_of_boxes(const std::vector<double>& at_m, double turn_rad = 0.0, double size_m = 0.5) {
  Scene scene;
  for (const double x_m : at_m) {
    scene.add_box(kTurned * Pose2{x_m, 0.0, turn_rad}, size_m, size_m);
  }
  return scene;
}

TEST(Columns, AGridIsFoundAsItStands) {
  Scene scene;
  double area_m2 = 0.0;
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 2; ++y) {
      scene.add_box(kTurned * Pose2{4.0 * x, 6.0 * y, 0.0}, 0.6, 0.4);
      area_m2 += 0.24;
    }
  }
  const std::vector<Ring> columns = scene.columns();
  ASSERT_EQ(columns.size(), 8u);
  double found_m2 = 0.0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    ASSERT_EQ(columns[i].size(), 4u);
    found_m2 += signed_area(columns[i]);
    for (const Point2& corner : columns[i]) {
      EXPECT_LT(distance_to_boundary(scene.pieces[i].outline.outer, corner), 1e-6);
    }
  }
  EXPECT_NEAR(found_m2, area_m2, 1e-6) << "counter-clockwise, of the same size";
}

TEST(Columns, RoundOnesAreRound) {
  Scene scene;
  for (const double x_m : {0.0, 5.0, 10.0}) scene.add_disc({x_m, 1.0}, 0.3);
  const std::vector<Ring> columns = scene.columns();
  ASSERT_EQ(columns.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    for (const Point2& corner : columns[i]) {
      EXPECT_NEAR((corner - Point2(5.0 * static_cast<double>(i), 1.0)).norm(), 0.3, 1e-3);
    }
  }
}

TEST(Columns, WhatIsNoRowOfThreeAlikeIsFurniture) {
  EXPECT_EQ(row_of_boxes({0.0, 4.0, 8.0}).columns().size(), 3u);
  EXPECT_TRUE(row_of_boxes({0.0, 4.0}).columns().empty());
  EXPECT_TRUE(row_of_boxes({0.0, 4.0, 8.6}).columns().empty()) << "uneven";
  EXPECT_TRUE(row_of_boxes({0.0, 1.2, 2.4}).columns().empty()) << "as near as tables";
  EXPECT_TRUE(row_of_boxes({0.0, 4.0, 8.0}, radians(20.0)).columns().empty()) << "askew";
  EXPECT_TRUE(row_of_boxes({0.0, 4.0, 8.0}, 0.0, 1.4).columns().empty()) << "too thick";
  Scene unlike = row_of_boxes({0.0, 4.0});
  unlike.add_box(kTurned * Pose2{8.0, 0.0, 0.0}, 0.5, 0.7);
  EXPECT_TRUE(unlike.columns().empty());
}

/// Without the surfaces that look along y, of pieces from one on.
Scene seen_in_part(Scene scene, std::size_t first) {
  const Point2 away = direction(kTurned.theta_rad + kPi / 2.0);
  std::erase_if(scene.surfaces, [&](const SurfacePoint& surface) {
    if (direction(surface.normal_rad).dot(away) < 0.9) return false;
    for (std::size_t i = first; i < scene.pieces.size(); ++i) {
      if (distance_to_boundary(scene.pieces[i].outline.outer, surface.at) < 0.1) return true;
    }
    return false;
  });
  return scene;
}

TEST(Columns, ASideThatNobodySawIsWhereItIsOnAnother) {
  const Scene whole = row_of_boxes({0.0, 4.0, 8.0, 12.0});
  const std::vector<Ring> columns = seen_in_part(whole, 1).columns();
  ASSERT_EQ(columns.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    for (const Point2& corner : columns[i]) {
      EXPECT_LT(distance_to_boundary(whole.pieces[i].outline.outer, corner), 1e-6);
    }
  }
  EXPECT_TRUE(seen_in_part(whole, 0).columns().empty()) << "may go on to any depth";
}

TEST(Columns, ARowWithAGapIsOneBesideAnother) {
  Scene scene = row_of_boxes({0.0, 4.0, 8.0, 12.0});
  for (const double x_m : {0.0, 4.0, 12.0}) {
    scene.add_box(kTurned * Pose2{x_m, 6.0, 0.0}, 0.5, 0.5);
  }
  EXPECT_EQ(scene.columns().size(), 7u);
  Scene alone = row_of_boxes({0.0, 4.0, 8.0, 12.0});
  alone.add_box(kTurned * Pose2{4.0, 6.0, 0.0}, 0.5, 0.5);
  alone.add_box(kTurned * Pose2{9.0, 6.0, 0.0}, 0.5, 0.5);
  EXPECT_EQ(alone.columns().size(), 4u);
}

TEST(Columns, PillarsOfAHallAreWallsOfIt) {
  const Drive drive = {{2.0, 2.0}, {18.0, 2.0}, {18.0, 7.5}, {2.0, 7.5}, {2.0, 13.0}, {18.0, 13.0}};
  const auto mission = test::known_mission("open_hall", drive, SensorKind::laser, {});
  const DraftedBuilding drafted = draft_building(mission.evidence, {});
  ASSERT_EQ(drafted.rooms.size(), 1u);
  const auto& holes = drafted.rooms.front().outline.holes;
  const auto& truth = mission.world.rooms.front().parts.front().holes;
  EXPECT_EQ(holes.size(), truth.size());
  for (const Ring& hole : holes) {
    EXPECT_LT(signed_area(hole), 0.0) << "clockwise";
    for (const Point2& corner : hole) {
      EXPECT_TRUE(std::any_of(truth.begin(), truth.end(), [&](const Ring& one) {
        return std::any_of(one.begin(), one.end(),
                           [&](const Point2& known) { return (known - corner).norm() < 0.02; });
      })) << corner.transpose();
    }
  }
  EXPECT_TRUE(drafted.furniture.empty());
}

}  // namespace
}  // namespace roomatlas
