// SPDX-License-Identifier: GPL-3.0-or-later
// Faces from echoes that are told by geometry alone: the nearest wall on the rays of each cone.
#include "roomatlas/draft/wall_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace roomatlas {
namespace {

constexpr double kHalfCone_rad = 10.0 * kPi / 180.0;
constexpr double kMaxRange_m = 5.0;
constexpr double kMostIncidence_rad = 40.0 * kPi / 180.0;

/// How far a ray goes to a wall that it meets squarely enough to be heard.
double heard_m(const Point2& from, double direction_rad, const Segment2& wall) {
  const Point2 ray = direction(direction_rad);
  const Point2 along = wall.b - wall.a;
  const double sine = ray.x() * along.y() - ray.y() * along.x();
  const Point2 to_wall = wall.a - from;
  const double on_ray = (to_wall.x() * along.y() - to_wall.y() * along.x()) / sine;
  const double on_wall = (to_wall.x() * ray.y() - to_wall.y() * ray.x()) / sine;
  const double incidence_rad = kPi / 2.0 - std::asin(std::abs(sine) / along.norm());
  const bool is_heard =
      on_ray > 0.0 && on_wall >= 0.0 && on_wall <= 1.0 && incidence_rad <= kMostIncidence_rad;
  return is_heard ? on_ray : kMaxRange_m;
}

Echo echo_of(const Pose2& beam, const std::vector<Segment2>& walls) {
  Echo echo{beam, kMaxRange_m, false, 0.0};
  for (int ray = -10; ray <= 10; ++ray) {
    for (const Segment2& wall : walls) {
      const double to_wall_m =
          heard_m(beam.position(), beam.theta_rad + ray * kHalfCone_rad / 10.0, wall);
      echo.range_m = std::min(echo.range_m, to_wall_m);
    }
  }
  echo.is_hit = echo.range_m < kMaxRange_m;
  echo.free_m = echo.range_m;
  return echo;
}

BuildingEvidence heard_in(const Ring& room, int readings) {
  std::vector<Segment2> walls;
  for (std::size_t i = 0; i < room.size(); ++i) {
    walls.push_back({room[i], room[(i + 1) % room.size()]});
  }
  BuildingEvidence evidence;
  evidence.kind = SensorKind::sonar;
  evidence.sonar_half_cone_rad = kHalfCone_rad;
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> on_x(0.6, 7.4), on_y(0.6, 5.4), turned(-kPi, kPi);
  const Polygon floor{room, {}};
  while (readings > 0) {
    const Point2 at(on_x(engine), on_y(engine));
    const double theta_rad = turned(engine);
    if (!contains(floor, at)) continue;
    --readings;
    const Echo echo = echo_of({at.x(), at.y(), theta_rad}, walls);
    evidence.echoes.push_back(echo);
    if (!echo.is_hit) continue;
    const Point2 end = at + echo.range_m * direction(theta_rad);
    evidence.counts.add_sweep({{{at, end}, true}});
  }
  return evidence;
}

/// Of all faces, how many metres lie on a wall and look its way, and how many do not.
struct Found {
  double on_walls_m = 0.0;
  double off_walls_m = 0.0;
};

Found found_in(const Ring& room, const std::vector<WallFace>& faces) {
  Found found;
  for (const WallFace& face : faces) {
    for (const Interval& seen : face.seen) {
      for (double on_m = seen.low_m + 0.05; on_m < seen.high_m; on_m += 0.1) {
        bool is_on = false;
        for (std::size_t i = 0; i < room.size(); ++i) {
          const Point2 along = (room[(i + 1) % room.size()] - room[i]).normalized();
          const double off_m = (face.at(on_m) - room[i]).dot(Point2(-along.y(), along.x()));
          const double turn_rad = wrap_angle(face.normal_rad - std::atan2(along.x(), -along.y()));
          is_on = is_on || (std::abs(off_m) < 0.05 && std::abs(turn_rad) < 3.0 * kPi / 180.0);
        }
        (is_on ? found.on_walls_m : found.off_walls_m) += 0.1;
      }
    }
  }
  return found;
}

TEST(SonarFaces, SlantedWallsAreStraightAndMakeNoSteps) {
  const Ring room = {{0.0, 0.0}, {8.0, 0.0}, {8.0, 2.5}, {4.5, 6.0}, {2.0, 6.0}, {0.0, 2.8}};
  const std::vector<WallFace> faces = find_wall_faces(heard_in(room, 6000), {});
  const Found found = found_in(room, faces);
  EXPECT_GT(found.on_walls_m, 0.75 * (length(room) + (room.front() - room.back()).norm()));
  EXPECT_LT(found.off_walls_m, 0.05 * found.on_walls_m);
  EXPECT_EQ(std::count_if(faces.begin(), faces.end(),
                          [](const WallFace& face) { return !face.is_regular; }),
            2);
}

TEST(SonarFaces, ARectangleHasNoSlantedOnes) {
  const Ring room = {{0.0, 0.0}, {8.0, 0.0}, {8.0, 6.0}, {0.0, 6.0}};
  const std::vector<WallFace> faces = find_wall_faces(heard_in(room, 4000), {});
  const Found found = found_in(room, faces);
  EXPECT_GT(found.on_walls_m, 0.75 * 28.0);
  EXPECT_LT(found.off_walls_m, 0.05 * found.on_walls_m);
  EXPECT_TRUE(std::all_of(faces.begin(), faces.end(),
                          [](const WallFace& face) { return face.is_regular; }));
}

}  // namespace
}  // namespace roomatlas
