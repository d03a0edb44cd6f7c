// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/match/match_maps.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>

#include "match/swept_room.hpp"

namespace roomatlas {
namespace {

using namespace test;

const WorldDrawing kOtherRoom = {"####################",  //
                                 "##                 #",  //
                                 "##  c              #",  //
                                 "##           ####  #",  //
                                 "#            ####  #",  //
                                 "#                  #",  //
                                 "#                  #",  //
                                 "#   b          ab  #",  //
                                 "#                  #",  //
                                 "#####              #",  //
                                 "####################"};

/// What a point that falls into a cell counts: on a face, beside one, in seen free space.
int cell_value(const LocalMap& map, const std::vector<Face>& faces, const Cell& cell) {
  int value = map.is_seen_free(cell) ? -30 : 0;
  for (const Face& face : faces) {
    const Cell at = map.frame().cell_of(face.position);
    const int apart = std::max(std::abs(at.x - cell.x), std::abs(at.y - cell.y));
    if (apart <= 1) value = std::max(value, apart == 0 ? 100 : 60);
  }
  return value;
}

/// The plain search: the value of a turn and a shift in whole cells.
class BruteForce {
 public:
  BruteForce(const LocalMap& map, const std::vector<ScanPoint>& points, const Pose2& guess,
             const SearchWindow& window)
      : map_(map), points_(points), guess_(guess), window_(window) {
    box_ = map.box();
    box_ = {{box_.min.x - 1, box_.min.y - 1}, {box_.max.x + 1, box_.max.y + 1}};
    const std::vector<Face> faces = map.faces(MatchMapsOptions{}.min_face_hits);
    for_each_cell(box_, [&](const Cell& cell) { values_.push_back(cell_value(map, faces, cell)); });
    double farthest_m = 5.0;
    for (const ScanPoint& p : points) farthest_m = std::max(farthest_m, p.position.norm());
    step_rad_ = std::max(radians(0.4), 0.1 / std::min(farthest_m, 12.0));
  }

  [[nodiscard]] double value(const Pose2& pose) const {
    double sum = 0.0;
    for (const ScanPoint& point : points_) {
      const Cell cell = map_.frame().cell_of(pose * point.position);
      if (box_.contains(cell)) sum += values_[box_.index_of(cell)];
    }
    const auto square = [](double sigmas) { return sigmas * sigmas; };
    const double off_m = (pose.position() - guess_.position()).norm();
    const double turn = wrap_angle(pose.theta_rad - guess_.theta_rad);
    double penalty = 0.5 * square(3.0 * off_m / window_.reach_m);
    if (window_.reach_rad > 0.0) penalty += 0.5 * square(3.0 * turn / window_.reach_rad);
    return sum / static_cast<double>(points_.size()) - penalty;
  }

  [[nodiscard]] double best() const {
    const int turns = static_cast<int>(std::ceil(window_.reach_rad / step_rad_));
    const int reach = static_cast<int>(std::ceil(window_.reach_m / 0.1));
    double best = -1e9;
    for (int turn = -turns; turn <= turns; ++turn) {
      for (int x = -reach; x <= reach; ++x) {
        for (int y = -reach; y <= reach; ++y) {
          best = std::max(best, value({guess_.x_m + 0.1 * x, guess_.y_m + 0.1 * y,
                                       wrap_angle(guess_.theta_rad + turn * step_rad_)}));
        }
      }
    }
    return best;
  }

 private:
  const LocalMap& map_;
  const std::vector<ScanPoint>& points_;
  Pose2 guess_;
  SearchWindow window_;
  CellBox box_;
  std::vector<int> values_;
  double step_rad_ = 0.0;
};

std::vector<ScanPoint> few_points_of(const LocalMap& map) {
  const std::vector<ScanPoint> points = points_of(map, {});
  return every((points.size() + 99) / 100, points);
}

TEST(MatchMaps, TheSearchFindsTheBestOfAllShiftsAndTurns) {
  const auto readings = every(4, readings_in(kUnevenRoom));
  const LocalMap first = map_of(readings);
  MatchMapsOptions coarse;
  coarse.align.max_iterations = 0;
  const SearchableMap searchable(first, coarse);
  const Pose2 second_from_world = {-3.0, 1.0, 0.4};
  const Pose2 truth = inverse(second_from_world);
  for (const WorldDrawing& drawing : {kUnevenRoom, kOtherRoom}) {
    const LocalMap second = map_of(every(4, readings_in(drawing)), second_from_world);
    const std::vector<ScanPoint> points = few_points_of(second);
    for (const Pose2& off : {Pose2{0.52, -0.31, 0.07}, Pose2{-0.9, 0.77, -0.13}}) {
      const Pose2 guess = truth * off;
      for (const SearchWindow& window : {SearchWindow{1.25, 0.16}, {0.4, 0.05}, {0.3, 0.0}}) {
        const BruteForce brute(first, points, guess, window);
        const Pose2 found = searchable.find(points, guess, window).first_from_second;
        EXPECT_NEAR(brute.value(found), brute.best(), 1e-9)
            << "reach " << window.reach_m << " m, off " << off.x_m;
      }
    }
  }
}

TEST(MatchMaps, FindsARoomThatLiesTwoMetresAndFifteenDegreesOff) {
  LaserRobot robot;
  robot.noise_m = 0.01;
  const LocalMap first = map_of(readings_in(kUnevenRoom, robot));
  const Polyline other_way = {{1.1, 3.4}, {6.0, 3.3}, {5.9, 1.2}, {2.0, 1.3}};
  const auto again = readings_along(surfaces_of(kUnevenRoom), other_way, robot);
  const Pose2 second_from_world{-1.0, 4.0, radians(50.0)};
  const Pose2 truth = inverse(second_from_world);
  const std::vector<ScanPoint> points = points_of(map_of(again, second_from_world), {});
  const SearchableMap searchable(first, {});
  for (const Pose2& off :
       {Pose2{1.6, 1.2, radians(15.0)}, Pose2{-2.0, 0.0, radians(-15.0)}, Pose2{0.0, 0.0, 0.0}}) {
    const Pose2 guess{truth.x_m + off.x_m, truth.y_m + off.y_m,
                      wrap_angle(truth.theta_rad + off.theta_rad)};
    const MapMatch match = searchable.find(points, guess, {3.0, radians(20.0)});
    EXPECT_LT((match.first_from_second.position() - truth.position()).norm(), 0.03);
    EXPECT_LT(turn_deg(match.first_from_second, truth), 0.3);
    EXPECT_GT(match.agreement(), 0.95);
    EXPECT_NEAR(match.agreeing + match.contradicting + match.unseen,
                static_cast<double>(points.size()), 2.0);
  }
}

TEST(MatchMaps, AnotherRoomContradicts) {
  const LocalMap first = map_of(readings_in(kUnevenRoom));
  const std::vector<ScanPoint> other = points_of(map_of(readings_in(kOtherRoom)), {});
  const MapMatch match = SearchableMap(first, {}).find(other, {}, {2.0, radians(20.0)});
  EXPECT_LT(match.agreement(), 0.65);
  EXPECT_GT(match.contradicting, 50);
}

TEST(MatchMaps, WhereNothingIsCommonNothingAgreesOrContradicts) {
  const LocalMap first = map_of(readings_in(kUnevenRoom));
  const std::vector<ScanPoint> points = points_of(first, {});
  const MapMatch match = SearchableMap(first, {}).find(points, {100.0, 0.0, 0.0}, {0.5, 0.1});
  EXPECT_EQ(match.agreeing, 0);
  EXPECT_EQ(match.contradicting, 0);
  EXPECT_EQ(match.agreement(), 0.0);
  EXPECT_EQ(SearchableMap(first, {}).find({}, {1.0, 2.0, 0.3}, {0.5, 0.1}).first_from_second,
            (Pose2{1.0, 2.0, 0.3}));
}

TEST(MatchMaps, ItsCovarianceIsWideAlongACorridorInTheFrameOfTheSecond) {
  const std::vector<Segment2> walls = {{{-30.0, 0.0}, {30.0, 0.0}}, {{30.0, 2.0}, {-30.0, 2.0}}};
  LaserRobot robot;
  robot.max_range_m = 4.0;
  robot.beams = 720;  // so dense that every return knows the wall's direction
  const LocalMap first = map_of(readings_along(walls, {{-3.0, 1.0}, {3.0, 1.0}}, robot));
  for (const double turned_deg : {0.0, 35.0, 120.0}) {
    const Pose2 second_from_world{1.0, 2.0, radians(turned_deg)};
    const auto again = readings_along(walls, {{-2.0, 1.1}, {2.0, 1.1}}, robot);
    const MapMatch match =
        SearchableMap(first, {}).find(points_of(map_of(again, second_from_world), {}),
                                      inverse(second_from_world), {0.3, radians(2.0)});
    const Eigen::Matrix3d covariance = match.information.inverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(
        Eigen::Matrix2d(covariance.topLeftCorner<2, 2>()));
    EXPECT_GT(std::sqrt(axes.eigenvalues()(1)), 20.0 * std::sqrt(axes.eigenvalues()(0)));
    const Point2 along = direction(radians(turned_deg));
    EXPECT_GT(std::abs(axes.eigenvectors().col(1).dot(along)), 0.99) << turned_deg;
    EXPECT_LT(degrees(std::sqrt(covariance(2, 2))), 1.0);
    EXPECT_LT((match.information - match.information.transpose()).norm(),
              1e-9 * match.information.norm());
  }
}

TEST(MatchMaps, NoMatchIsMoreCertainThanItsFloor) {
  const LocalMap map = map_of(readings_in(kUnevenRoom));
  const MapMatch match = SearchableMap(map, {}).find(points_of(map, {}), {}, {0.3, 0.05});
  const Eigen::Matrix3d covariance = match.information.inverse();
  EXPECT_GE(std::sqrt(covariance(0, 0)), 0.02 - 1e-9);
  EXPECT_GE(std::sqrt(covariance(1, 1)), 0.02 - 1e-9);
  EXPECT_GE(degrees(std::sqrt(covariance(2, 2))), 0.15 - 1e-9);
  EXPECT_LT(std::sqrt(covariance(0, 0)), 0.1);
}

}  // namespace
}  // namespace roomatlas
