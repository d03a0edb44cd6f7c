// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/match/moving_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "match/swept_room.hpp"

namespace roomatlas {
namespace {

constexpr double kHall_m = 8.0;  // walls at plus and minus this on x, and half of it on y

double to_wall_m(const Point2& from, const Point2& ray) {
  const auto until = [](double at, double along, double half_m) {
    if (along == 0.0) return std::numeric_limits<double>::infinity();
    return ((along > 0.0 ? half_m : -half_m) - at) / along;
  };
  return std::min(until(from.x(), ray.x(), kHall_m), until(from.y(), ray.y(), kHall_m / 2.0));
}

struct Seen {
  Scan scan;
  std::vector<int> disc_of;  ///< for each point, which disc it lies on; -1: a wall
};

/// All around, a point each half degree.
/// @param discs middles of people and of a column, 0.22 m in radius
Seen seen_in_hall(const Pose2& hall_from_robot, const std::vector<Point2>& discs) {
  Seen seen;
  for (int i = 0; i < 720; ++i) {
    const double bearing_rad = radians(0.5 * i);
    const Point2 ray = direction(hall_from_robot.theta_rad + bearing_rad);
    double range_m = to_wall_m(hall_from_robot.position(), ray);
    int met = -1;
    for (std::size_t d = 0; d < discs.size(); ++d) {
      const double disc_m = test::to_disc_m(hall_from_robot.position(), ray, discs[d]);
      if (disc_m < range_m) met = static_cast<int>(d);
      range_m = std::min(range_m, disc_m);
    }
    seen.scan.points.push_back({range_m * direction(bearing_rad), Point2::Zero(), true});
    seen.disc_of.push_back(met);
  }
  return seen;
}

/// Shares of the points on each of two discs, and on walls, that were hidden.
struct Hidden {
  double first = 0.0;
  double second = 0.0;
  double walls = 0.0;
};

Hidden hidden_of(const Seen& seen) {
  const auto share = [&](int disc) {
    int all = 0;
    int hidden = 0;
    for (std::size_t i = 0; i < seen.disc_of.size(); ++i) {
      if (seen.disc_of[i] != disc) continue;
      ++all;
      hidden += seen.scan.points[i].is_hit ? 0 : 1;
    }
    return all > 0 ? static_cast<double>(hidden) / all : 0.0;
  };
  return {share(0), share(1), share(-1)};
}

/// Drives 2 s along x at 0.5 m/s while the first disc moves and the second stands.
/// @param told what odometry makes of a true step
/// @param is_held_back matched sweeps found that the robot stood
Hidden after_driving(const Point2& start, const Point2& velocity, double told = 1.0,
                     double turn_rad = 0.0, bool is_held_back = false) {
  MovingPoints moving{MovingPointsOptions{}};
  Hidden hidden;
  for (int i = 0; i <= 20; ++i) {
    const Pose2 pose{0.05 * i, 0.0, turn_rad * i};
    Seen seen = seen_in_hall(pose, {start + 0.1 * i * velocity, {3.0, -2.0}});
    const Pose2 odometry{told * pose.x_m, 0.0, pose.theta_rad};
    moving.hide(seen.scan, 0.1 * i, odometry, is_held_back ? Pose2{0.0, 0.0, turn_rad * i} : pose);
    hidden = hidden_of(seen);
  }
  return hidden;
}

TEST(MovingPoints, APersonIsHiddenAndWhatStandsIsNot) {
  struct Case {
    const char* name;
    Point2 start;
    Point2 velocity;
  };
  for (const Case& walk : {Case{"ahead, as fast", {1.5, 0.0}, {0.5, 0.0}},
                           Case{"ahead, faster", {1.0, 0.3}, {1.0, 0.0}},
                           Case{"towards the robot", {5.0, 0.4}, {-1.0, 0.0}},
                           Case{"across", {3.0, -1.0}, {0.0, 0.8}}}) {
    SCOPED_TRACE(walk.name);
    const Hidden hidden = after_driving(walk.start, walk.velocity);
    EXPECT_GT(hidden.first, 0.6);  // not where an edge was seen
    EXPECT_EQ(hidden.second, 0.0);
    EXPECT_LT(hidden.walls, 0.02);
    EXPECT_GT(after_driving(walk.start, walk.velocity, 1.0, 0.0, true).first, 0.6);
  }
}

TEST(MovingPoints, NothingIsHiddenWhereNothingMoves) {
  for (const double turn_rad : {0.0, radians(2.0), radians(-5.0)}) {
    const Hidden hidden = after_driving({2.0, 1.0}, {0.0, 0.0}, 1.0, turn_rad);
    EXPECT_EQ(hidden.first, 0.0);
    EXPECT_EQ(hidden.second, 0.0);
    EXPECT_EQ(hidden.walls, 0.0);
  }
}

TEST(MovingPoints, WallsAreNotHiddenWhereWheelsSlip) {
  EXPECT_LT(after_driving({2.0, 1.0}, {0.0, 0.0}, 3.0).walls, 0.02);  // told 3 m, driven 1 m
  EXPECT_LT(after_driving({2.0, 1.0}, {0.0, 0.0}, -1.0).walls, 0.02);
}

TEST(MovingPoints, ForgetsWhatItSaw) {
  MovingPoints moving{MovingPointsOptions{}};
  for (int i = 0; i < 5; ++i) {
    Seen before = seen_in_hall({}, {});
    EXPECT_EQ(moving.hide(before.scan, 0.25 * i, {}, {}), 0);
  }
  Seen with_person = seen_in_hall({}, {{2.0, 0.0}});
  Seen again = with_person;
  EXPECT_GT(moving.hide(with_person.scan, 2.0, {}, {}), 20);
  moving.clear();
  EXPECT_EQ(moving.hide(again.scan, 2.1, {}, {}), 0);
}

}  // namespace
}  // namespace roomatlas
