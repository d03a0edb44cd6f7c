// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>

#include "roomatlas/asr/map_room.hpp"

namespace roomatlas {
namespace {

/// A door of 0.9 m in the wall x = 0; the room is on the left of it (x < 0).
Exit door_at(const Pose2& frame_from_pivot) {
  Exit exit;
  exit.frame_from_pivot = frame_from_pivot;
  exit.width_m = 0.9;
  exit.jambs = {frame_from_pivot * Point2(0.0, 0.45), frame_from_pivot * Point2(0.0, -0.45)};
  return exit;
}

std::optional<Ray> clipped(const Point2& from, const Point2& to, bool ends_at_obstacle = true) {
  return clipped_at_doorway({{from, to}, ends_at_obstacle}, door_at({}));
}

void expect_ray(const std::optional<Ray>& ray, const Point2& from, const Point2& to,
                bool ends_at_obstacle) {
  ASSERT_TRUE(ray);
  EXPECT_LT((ray->segment.a - from).norm(), 1e-9);
  EXPECT_LT((ray->segment.b - to).norm(), 1e-9);
  EXPECT_EQ(ray->ends_at_obstacle, ends_at_obstacle);
}

TEST(ClippedAtDoorway, KeepsARayThatStaysInTheRoom) {
  expect_ray(clipped({-2, 0}, {-0.5, 1}), {-2, 0}, {-0.5, 1}, true);
  expect_ray(clipped({-2, 0}, {-0.5, 1}, false), {-2, 0}, {-0.5, 1}, false);
}

TEST(ClippedAtDoorway, EndsARayThroughTheDoorAtTheDoorLineInFreeSpace) {
  expect_ray(clipped({-2, 0}, {3, 0}), {-2, 0}, {0, 0}, false);
  expect_ray(clipped({-2, -0.6}, {2, 1.0}), {-2, -0.6}, {0, 0.2}, false);
}

TEST(ClippedAtDoorway, KeepsARayThatPassesBesideTheDoor) {
  expect_ray(clipped({-2, 2}, {3, 2}), {-2, 2}, {3, 2}, true);
  expect_ray(clipped({-1, -3}, {1, -1}), {-1, -3}, {1, -1}, true);
}

TEST(ClippedAtDoorway, KeepsWhatARayFromTheDoorwayShowsOfTheRoom) {
  expect_ray(clipped({0.4, 0}, {-3, 0}), {0, 0}, {-3, 0}, true);
  expect_ray(clipped({0.4, 0.1}, {-1.2, -0.7}, false), {0, -0.1}, {-1.2, -0.7}, false);
}

TEST(ClippedAtDoorway, DropsWhatARayFromTheDoorwayShowsOfTheOtherRoom) {
  EXPECT_FALSE(clipped({0.4, 0}, {4, 0}));
  EXPECT_FALSE(clipped({0.4, 0}, {0.1, 3}));
  EXPECT_FALSE(clipped({0.4, 0}, {-0.2, 2})) << "it would have to come through the wall";
}

TEST(ClippedAtDoorway, KeepsRaysFromAPartOfTheRoomThatLiesBehindTheDoorsPlaneFarAway) {
  expect_ray(clipped({5, 6}, {7, 6}), {5, 6}, {7, 6}, true);
  expect_ray(clipped({5, 6}, {-1, 6}), {5, 6}, {-1, 6}, true);
}

/// Rays anywhere around the door, longer than nothing.
std::vector<Ray> random_rays() {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> across(-3.0, 3.0);
  std::vector<Ray> rays;
  for (int i = 0; i < 500; ++i) {
    rays.push_back(
        {{{across(random), across(random)}, {across(random), across(random)}}, i % 2 == 0});
  }
  return rays;
}

TEST(ClippedAtDoorway, KeepsPointByPointWhatCanBeSeenOfTheRoom) {
  // Second route: walk along each ray. What was kept is a piece of the ray from its start, or up
  // to its end; no kept point is one that the ray reached through the door.
  for (const Ray& ray : random_rays()) {
    if (ray.segment.a.x() > 0.0) continue;  // from inside the room
    const auto kept = clipped_at_doorway(ray, door_at({}));
    ASSERT_TRUE(kept);
    EXPECT_EQ(kept->segment.a, ray.segment.a);
    bool went_through = false;
    Point2 last = ray.segment.a;
    for (int step = 0; step <= 1000; ++step) {
      const Point2 at = ray.segment.a + step / 1000.0 * (ray.segment.b - ray.segment.a);
      if (last.x() <= 0.0 && at.x() > 0.0 && std::abs(at.y()) < 0.45) went_through = true;
      ASSERT_TRUE(!went_through || distance(kept->segment, at) > 0.0);
      last = at;
    }
    EXPECT_FALSE(went_through && kept->ends_at_obstacle);
    const bool stays_inside = ray.segment.b.x() <= 0.0;
    EXPECT_TRUE(!stays_inside || kept->segment.b == ray.segment.b);
  }
}

TEST(ClippedAtDoorway, DoesNotDependOnWhereTheDoorLies) {
  const Pose2 moved{3.0, -1.5, 2.2};
  for (const Ray& ray : random_rays()) {
    const auto here = clipped_at_doorway(ray, door_at({}));
    const auto there =
        clipped_at_doorway({transformed(moved, ray.segment), ray.ends_at_obstacle}, door_at(moved));
    ASSERT_EQ(here.has_value(), there.has_value());
    if (!here) continue;
    const Segment2 expected = transformed(moved, here->segment);
    expect_ray(there, expected.a, expected.b, here->ends_at_obstacle);
  }
}

TEST(ClippedAtDoorway, ClipsNoMoreTheSecondTime) {
  for (const Ray& ray : random_rays()) {
    const auto once = clipped_at_doorway(ray, door_at({}));
    if (!once || ray.segment.a.x() > 0.0) continue;
    const auto twice = clipped_at_doorway(*once, door_at({}));
    expect_ray(twice, once->segment.a, once->segment.b, once->ends_at_obstacle);
  }
}

}  // namespace
}  // namespace roomatlas
