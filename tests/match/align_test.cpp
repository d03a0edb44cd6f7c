// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/match/align.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "match/swept_room.hpp"
#include "roomatlas/grid/himm_grid.hpp"

namespace roomatlas {
namespace {

using namespace test;

using Cost = std::function<double(const Eigen::Vector3d&)>;

Eigen::Vector3d vector_of(const Pose2& pose) { return {pose.x_m, pose.y_m, pose.theta_rad}; }

Eigen::Vector3d numeric_gradient(const Cost& cost, const Eigen::Vector3d& at, double step) {
  Eigen::Vector3d gradient;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d off = step * Eigen::Vector3d::Unit(i);
    gradient(i) = (cost(at + off) - cost(at - off)) / (2.0 * step);
  }
  return gradient;
}

Eigen::Matrix3d numeric_hessian(const Cost& cost, const Eigen::Vector3d& at, double step) {
  Eigen::Matrix3d hessian;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Eigen::Vector3d a = step * Eigen::Vector3d::Unit(i);
      const Eigen::Vector3d b = step * Eigen::Vector3d::Unit(j);
      hessian(i, j) = (cost(at + a + b) - cost(at + a - b) - cost(at - a + b) + cost(at - a - b)) /
                      (4.0 * step * step);
    }
  }
  return hessian;
}

/// The partner by going through all faces.
const Face* nearest_of(const std::vector<Face>& faces, const Point2& at, const Point2& normal,
                       const AlignOptions& options) {
  const Face* best = nullptr;
  for (const Face& face : faces) {
    const double apart_m = (face.position - at).norm();
    if (apart_m >= options.last_gate_m) continue;
    if (face.normal != Point2::Zero() && normal != Point2::Zero() &&
        face.normal.dot(normal) < options.min_normal_cosine) {
      continue;
    }
    if (best == nullptr || apart_m < (best->position - at).norm()) best = &face;
  }
  return best;
}

/// Half of the sum of Cauchy's losses s^2 log(1 + r^2 / s^2), whose weights `align` uses, with the
/// partners that the points have at `pose`.
Cost cost_around(const std::vector<Face>& faces, const std::vector<ScanPoint>& points,
                 const Pose2& pose, const AlignOptions& options) {
  struct Pair {
    Face face;
    Point2 point;
  };
  std::vector<Pair> pairs;
  const Pose2 turn{0.0, 0.0, pose.theta_rad};
  for (const ScanPoint& point : points) {
    if (!point.is_hit) continue;
    const Face* face = nearest_of(faces, pose * point.position, turn * point.normal, options);
    if (face != nullptr) pairs.push_back({*face, point.position});
  }
  return [pairs, options](const Eigen::Vector3d& x) {
    const double s2 = options.robust_m * options.robust_m;
    const Pose2 at{x(0), x(1), x(2)};
    double cost = 0.0;
    for (const Pair& pair : pairs) {
      const Point2 off = at * pair.point - pair.face.position;
      const bool is_corner = pair.face.normal == Point2::Zero();
      const double square = is_corner ? off.squaredNorm() : std::pow(off.dot(pair.face.normal), 2);
      cost += (is_corner ? options.corner_weight : 1.0) * s2 / 2.0 * std::log1p(square / s2);
    }
    return cost;
  };
}

/// Walls on all sides, a slanted one, and a corner post without a direction.
std::vector<ScanPoint> literal_room() {
  std::vector<ScanPoint> faces;
  for (const auto& [from, to] : {std::pair<Point2, Point2>{{0.0, 0.05}, {4.0, 0.05}},
                                 {{4.05, 0.3}, {4.05, 2.0}},
                                 {{3.0, 3.05}, {1.0, 3.05}},
                                 {{0.7, 2.6}, {0.15, 1.9}}}) {
    for (const ScanPoint& face : wall_between(from, to)) faces.push_back(face);
  }
  faces.push_back({{2.05, 1.55}, Point2::Zero(), true});
  return faces;
}

TEST(Align, RecoversTheOffsetOfASweepInADrawnRoom) {
  const auto readings = readings_in(kUnevenRoom);
  const LocalMap map = map_of(readings);
  for (const std::size_t i : {0U, 60U, 120U, 170U}) {
    const RangeReading& reading = readings[i];
    const std::vector<ScanPoint> points = scan_of(reading, {}).points;
    for (const Pose2& off : {Pose2{}, Pose2{0.1, -0.08, radians(3.0)},
                             Pose2{-0.12, 0.1, radians(-4.0)}, Pose2{0.0, 0.15, 0.0}}) {
      const Pose2& truth = reading.odom_from_robot;
      const ScanAlignment aligned = align(map, points, truth * off, std::nullopt, {});
      EXPECT_LT((aligned.map_from_points.position() - truth.position()).norm(), 0.01) << i;
      EXPECT_LT(turn_deg(aligned.map_from_points, truth), 0.2) << i;
      EXPECT_GT(aligned.matched, 0.9 * aligned.points) << i;
    }
  }
}

TEST(Align, ItsHessianIsThatOfTheCostWhereEveryPointLiesOnItsFace) {
  const LocalMap map = map_with(literal_room());
  const Pose2 pose{1.3, 0.8, 0.7};
  const std::vector<ScanPoint> points = seen_from(pose, literal_room());
  const AlignOptions options;
  const ScanAlignment aligned = align(map, points, pose, std::nullopt, options);
  EXPECT_EQ(aligned.points, static_cast<int>(points.size()));
  EXPECT_EQ(aligned.matched, aligned.points);
  EXPECT_LT((vector_of(aligned.map_from_points) - vector_of(pose)).norm(), 1e-9);
  const Eigen::Matrix3d numeric =
      numeric_hessian(cost_around(map.faces(0.0), points, pose, options), vector_of(pose), 1e-4);
  EXPECT_LT((aligned.hessian - numeric).norm(), 1e-3 * numeric.norm()) << aligned.hessian << "\n\n"
                                                                       << numeric;
}

TEST(Align, EndsWhereTheCostIsLevelWithAndWithoutAPrior) {
  std::mt19937 random(2);
  std::normal_distribution<double> noise(0.0, 0.01);
  const LocalMap map = map_with(literal_room());
  const Pose2 pose{1.3, 0.8, 0.7};
  std::vector<ScanPoint> points = seen_from(pose, literal_room());
  for (ScanPoint& point : points) point.position += Point2(noise(random), noise(random));
  AlignOptions options;
  options.max_iterations = 200;
  const PosePrior prior{pose * Pose2{0.03, -0.02, 0.02}, 0.02, 0.01};
  for (const bool has_prior : {false, true}) {
    const auto given = has_prior ? std::optional<PosePrior>(prior) : std::nullopt;
    const Pose2 start = pose * Pose2{0.02, 0.02, -0.02};
    const Pose2 found = align(map, points, start, given, options).map_from_points;
    const Cost of_points = cost_around(map.faces(0.0), points, found, options);
    const Cost cost = [&](const Eigen::Vector3d& x) {
      if (!has_prior) return of_points(x);
      const Eigen::Vector3d off = x - vector_of(prior.mean);
      const double s2 = options.robust_m * options.robust_m;
      return of_points(x) + s2 / 2.0 *
                                (off.head<2>().squaredNorm() / std::pow(prior.position_sigma_m, 2) +
                                 std::pow(off(2) / prior.heading_sigma_rad, 2));
    };
    const double at_start = numeric_gradient(cost, vector_of(start), 1e-5).norm();
    EXPECT_LT(numeric_gradient(cost, vector_of(found), 1e-5).norm(), 1e-3 * at_start) << has_prior;
  }
}

TEST(Align, ThePriorHoldsTheDirectionAlongAnEndlessCorridor) {
  std::vector<ScanPoint> walls = wall_between({-10.0, -1.05}, {10.0, -1.05});
  for (const ScanPoint& face : wall_between({10.0, 1.05}, {-10.0, 1.05})) walls.push_back(face);
  const LocalMap map = map_with(walls);
  std::vector<ScanPoint> seen = wall_between({-3.0, -1.05}, {3.0, -1.05});
  for (const ScanPoint& face : wall_between({3.0, 1.05}, {-3.0, 1.05})) seen.push_back(face);
  const Pose2 truth{0.4, 0.2, 0.3};
  const std::vector<ScanPoint> points = seen_from(truth, seen);
  for (const double along_m : {0.0, 0.07, -0.11}) {
    const PosePrior prior{
        {truth.x_m + along_m, truth.y_m + 0.06, truth.theta_rad + 0.03}, 0.02, 0.02};
    const Pose2 held = align(map, points, prior.mean, prior, {}).map_from_points;
    EXPECT_NEAR(held.x_m, prior.mean.x_m, 1e-3);
    EXPECT_NEAR(held.y_m, truth.y_m, 0.01);
    EXPECT_NEAR(held.theta_rad, truth.theta_rad, 0.005);
  }
  const ScanAlignment aligned = align(map, points, truth, std::nullopt, {});
  EXPECT_LT(aligned.hessian(0, 0), 1e-6) << "nothing is known along the corridor";
  EXPECT_GT(aligned.hessian(1, 1), 100.0);
}

TEST(Align, LeavesOutFreeRaysAndWhatFacesTheOtherWay) {
  const LocalMap map = map_with(wall_between({0.0, 0.05}, {3.0, 0.05}));
  std::vector<ScanPoint> points = wall_between({0.0, 0.05}, {3.0, 0.05});
  ASSERT_EQ(points.size(), 30U);
  for (int i = 0; i < 7; ++i) points[static_cast<std::size_t>(i)].is_hit = false;
  for (int i = 7; i < 18; ++i) points[static_cast<std::size_t>(i)].normal *= -1.0;
  const ScanAlignment aligned = align(map, points, {}, std::nullopt, {});
  EXPECT_EQ(aligned.points, 23);
  EXPECT_EQ(aligned.matched, 12);
  const ScanAlignment none = align(LocalMap(0.1), points, {1.0, 2.0, 0.3}, std::nullopt, {});
  EXPECT_EQ(none.matched, 0);
  EXPECT_EQ(none.map_from_points, (Pose2{1.0, 2.0, 0.3}));
}

/// The score of a pose of the lattice, computed the plain way.
double correlation(const LocalMap& map, const std::vector<ScanPoint>& points,
                   const PosePrior& prior, const Pose2& pose, const CorrelateOptions& options) {
  double sum = 0.0;
  for (const ScanPoint& point : points) {
    const Point2 at = pose * point.position;
    const Cell cell{static_cast<int>(std::floor(at.x() / 0.1)),
                    static_cast<int>(std::floor(at.y() / 0.1))};
    sum += std::max(0, map.certainty(cell)) / 30.0;
  }
  const double position = (pose.position() - prior.mean.position()).norm();
  const double turn = wrap_angle(pose.theta_rad - prior.mean.theta_rad);
  return sum / static_cast<double>(points.size()) -
         options.penalty * (std::pow(position / prior.position_sigma_m, 2) +
                            std::pow(turn / prior.heading_sigma_rad, 2));
}

TEST(Correlate, FindsTheBestPoseOfItsLattice) {
  const auto readings = readings_in(kUnevenRoom);
  const LocalMap map = map_of(readings);
  const CorrelateOptions options;
  for (const std::size_t i : {10U, 90U, 150U}) {
    const std::vector<ScanPoint> points = every(3, scan_of(readings[i], {}).points);
    ASSERT_LE(points.size(), 90U);
    const PosePrior prior{readings[i].odom_from_robot * Pose2{0.093, -0.071, radians(2.6)}, 0.06,
                          radians(3.0)};
    const Pose2 found = correlate(map, points, prior, options);

    double best = -1.0;
    double nearest = 1.0;  // pose of the lattice to the one found
    for (int turn = -4; turn <= 4; ++turn) {
      for (int x = -3; x <= 3; ++x) {
        for (int y = -3; y <= 3; ++y) {
          const Pose2 pose{prior.mean.x_m + 0.05 * x, prior.mean.y_m + 0.05 * y,
                           wrap_angle(prior.mean.theta_rad + radians(turn))};
          best = std::max(best, correlation(map, points, prior, pose, options));
          nearest = std::min(nearest, (vector_of(pose) - vector_of(found)).norm());
        }
      }
    }
    EXPECT_LT(nearest, 1e-12);
    EXPECT_NEAR(correlation(map, points, prior, found, options), best, 1e-9);
  }
}

TEST(Correlate, WithoutPointsStaysAtThePrior) {
  const PosePrior prior{{1.0, 2.0, 0.5}, 0.1, 0.1};
  EXPECT_EQ(correlate(LocalMap(0.1), {}, prior, {}), prior.mean);
}

}  // namespace
}  // namespace roomatlas
