// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/polyline/simplify.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace roomatlas {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Indices = std::vector<std::size_t>;

Polyline random_walk(std::mt19937& random, int count) {
  std::normal_distribution<double> step(0.0, 0.3);
  Polyline line = {{1.0, -2.0}};
  for (int i = 1; i < count; ++i) {
    line.push_back(line.back() + Point2(0.1 + step(random), step(random)));
  }
  return line;
}

Polyline points_of(const Polyline& line, const Indices& kept) {
  Polyline result;
  for (const std::size_t i : kept) result.push_back(line[i]);
  return result;
}

/// Distance from p to the segment from a to b: to its line where the foot lies on it, otherwise
/// to the nearer end.
double distance_by_cases(const Point2& a, const Point2& b, const Point2& p) {
  const Point2 ab = b - a;
  const bool foot_is_inside = (p - a).dot(ab) > 0.0 && (p - b).dot(ab) < 0.0;
  if (!foot_is_inside) return std::min((p - a).norm(), (p - b).norm());
  return std::abs(cross(ab, p - a)) / ab.norm();
}

/// Douglas and Peucker as the paper tells it, by recursion.
void keep_between(const Polyline& line, std::size_t first, std::size_t last, double tolerance_m,
                  std::set<std::size_t>& kept) {
  kept.insert({first, last});
  std::size_t farthest = first;
  double farthest_m = 0.0;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double off_m = distance_by_cases(line[first], line[last], line[i]);
    if (off_m > farthest_m) {
      farthest_m = off_m;
      farthest = i;
    }
  }
  if (farthest_m <= tolerance_m) return;
  keep_between(line, first, farthest, tolerance_m, kept);
  keep_between(line, farthest, last, tolerance_m, kept);
}

Indices douglas_peucker_by_recursion(const Polyline& line, double tolerance_m,
                                     const Indices& pinned = {}) {
  std::set<std::size_t> kept;
  std::set<std::size_t> ends(pinned.begin(), pinned.end());
  ends.insert({0, line.size() - 1});
  for (auto end = std::next(ends.begin()); end != ends.end(); ++end) {
    keep_between(line, *std::prev(end), *end, tolerance_m, kept);
  }
  return {kept.begin(), kept.end()};
}

TEST(DouglasPeucker, KeepsTheCornersOfAnLAndDropsThePointsBetween) {
  const Polyline wall = {{0, 0}, {1, 0.05}, {2, -0.05}, {3, 0}, {3.05, 1}, {2.95, 2}, {3, 3}};
  EXPECT_THAT(douglas_peucker(wall, 0.1), ElementsAre(0, 3, 6));
  EXPECT_THAT(douglas_peucker(wall, 0.01), ElementsAre(0, 1, 2, 3, 4, 5, 6));
  EXPECT_THAT(douglas_peucker(wall, 9.0), ElementsAre(0, 6));
}

TEST(DouglasPeucker, AgreesWithTheRecursionOnRandomWalks) {
  std::mt19937 random(31);
  for (int round = 0; round < 200; ++round) {
    const Polyline line = random_walk(random, 2 + round);
    const Indices pinned =
        round % 2 == 0 ? Indices{} : Indices{0, line.size() / 3, line.size() / 2};
    for (const double tolerance_m : {0.05, 0.3, 1.0}) {
      EXPECT_EQ(douglas_peucker(line, tolerance_m, pinned),
                douglas_peucker_by_recursion(line, tolerance_m, pinned));
    }
  }
}

TEST(DouglasPeucker, LeavesEachDroppedPointWithinToleranceOfTheEdgeThatReplacesIt) {
  std::mt19937 random(32);
  for (int round = 0; round < 50; ++round) {
    const Polyline line = random_walk(random, 200);
    const Indices kept = douglas_peucker(line, 0.4);
    EXPECT_LT(kept.size(), line.size());
    for (std::size_t e = 1; e < kept.size(); ++e) {
      for (std::size_t i = kept[e - 1]; i <= kept[e]; ++i) {
        EXPECT_LE(distance_by_cases(line[kept[e - 1]], line[kept[e]], line[i]), 0.4 + 1e-12);
      }
    }
  }
}

TEST(DouglasPeucker, MeasuresToTheEdgeAndNotToItsLine) {
  const Polyline spike = {{0, 0}, {5, 0}, {1, 0}};
  EXPECT_THAT(douglas_peucker(spike, 0.5), ElementsAre(0, 1, 2));
}

TEST(DouglasPeucker, KeepsTheFarthestPointOfAChainThatEndsWhereItBegan) {
  const Polyline closed = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}};
  EXPECT_THAT(douglas_peucker(closed, 0.1), ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(douglas_peucker(closed, 2.0), ElementsAre(0, 2, 4));
}

TEST(DouglasPeucker, ChangesNothingMoreWhenItsResultIsSimplifiedAgain) {
  std::mt19937 random(33);
  for (int round = 0; round < 50; ++round) {
    const Polyline line = random_walk(random, 200);
    const Polyline once = points_of(line, douglas_peucker(line, 0.4));
    EXPECT_EQ(points_of(once, douglas_peucker(once, 0.4)), once);
  }
}

TEST(DouglasPeucker, KeepsPinnedPointsWhateverTheTolerance) {
  const Polyline wall = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}};
  EXPECT_THAT(douglas_peucker(wall, 1.0, {1, 3}), ElementsAre(0, 1, 3, 4));
  EXPECT_THAT(douglas_peucker(wall, 1.0, {0, 4}), ElementsAre(0, 4));
}

TEST(DouglasPeucker, KeepsTheSamePointsOfATurnedAndShiftedLine) {
  std::mt19937 random(34);
  for (const double turn_rad : {0.3, kPi / 2.0, -2.5}) {
    const Polyline line = random_walk(random, 150);
    const Polyline moved = transformed({-7.0, 3.0, turn_rad}, line);
    EXPECT_EQ(douglas_peucker(moved, 0.3), douglas_peucker(line, 0.3));
    EXPECT_EQ(decimate(moved, 0.3), decimate(line, 0.3));
  }
}

TEST(DouglasPeucker, KeepsAllOfFewerThanThreePoints) {
  EXPECT_THAT(douglas_peucker({}, 1.0), IsEmpty());
  EXPECT_THAT(douglas_peucker({{1, 1}}, 1.0), ElementsAre(0));
  EXPECT_THAT(douglas_peucker({{1, 1}, {1, 1}}, 1.0), ElementsAre(0, 1));
}

/// III.D: V[i + m] goes while it is nearer than tau to V[i]; the first that is not becomes i.
Indices decimate_as_in_the_paper(const Polyline& v, double tau_m) {
  Indices kept;
  for (std::size_t i = 0; i < v.size();) {
    kept.push_back(i);
    std::size_t m = 1;
    while (i + m < v.size() && (v[i] - v[i + m]).norm() < tau_m) ++m;
    i += m;
  }
  return kept;
}

TEST(Decimate, FollowsThePaperAndKeepsTheLastPointBesides) {
  std::mt19937 random(35);
  for (int round = 0; round < 100; ++round) {
    const Polyline line = random_walk(random, 1 + round);
    Indices expected = decimate_as_in_the_paper(line, 0.6);
    if (expected.back() + 1 != line.size()) expected.push_back(line.size() - 1);
    EXPECT_EQ(decimate(line, 0.6), expected);
  }
}

TEST(Decimate, DropsPointsNearerThanTauAndKeepsPinnedOnes) {
  const Polyline line = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}};
  EXPECT_THAT(decimate(line, 2.0), ElementsAre(0, 2, 4, 5));
  EXPECT_THAT(decimate(line, 2.0, {1}), ElementsAre(0, 1, 3, 5));
  EXPECT_THAT(decimate(line, 0.0), ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(Decimate, KeepsAllOfFewerThanThreePoints) {
  EXPECT_THAT(decimate({}, 1.0), IsEmpty());
  EXPECT_THAT(decimate({{1, 1}}, 1.0), ElementsAre(0));
  EXPECT_THAT(decimate({{1, 1}, {1, 1}}, 1.0), ElementsAre(0, 1));
}

}  // namespace
}  // namespace roomatlas
