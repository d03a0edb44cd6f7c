// SPDX-License-Identifier: GPL-3.0-or-later
#include "merge/shapes.hpp"

#include <gmock/gmock.h>

#include <limits>
#include "roomatlas/planar/union.hpp"

namespace roomatlas {
namespace {

using test::rectangle;
using test::total_area;

TEST(Difference, OfASquareAndItsMiddleIsARingAndOfASquareAndItselfNothing) {
  const std::vector<Polygon> square = {{rectangle(0, 0, 3, 3), {}}};
  const auto ring = difference_of(square, {{rectangle(1, 1, 2, 2), {}}});
  ASSERT_EQ(ring.size(), 1U);
  EXPECT_EQ(ring.front().holes.size(), 1U);
  EXPECT_NEAR(area(ring.front()), 8.0, 1e-6);
  EXPECT_TRUE(difference_of(square, square).empty());
  EXPECT_TRUE(difference_of({}, square).empty());
  EXPECT_NEAR(area(difference_of(square, {}).front()), 9.0, 1e-6);
}

TEST(Difference, IsWhatIsLeftOfTheAreaThatBothCover) {
  const std::vector<Polygon> first = {{rectangle(0, 0, 4, 1), {}}, {rectangle(1, 0, 2, 5), {}}};
  const std::vector<Polygon> second = {{rectangle(0.5, 0.5, 3, 2), {}}};
  double whole_m2 = 0.0;
  double left_m2 = 0.0;
  for (const Polygon& part : union_of(first)) whole_m2 += area(part);
  for (const Polygon& part : difference_of(first, second)) left_m2 += area(part);
  EXPECT_NEAR(left_m2, whole_m2 - overlap_area(first, second), 1e-6);
}

TEST(Union, OfNothingIsEmpty) {
  EXPECT_TRUE(union_of({}).empty());
  EXPECT_TRUE(union_of({Polygon{}, Polygon{}}).empty());
  EXPECT_EQ(overlap_area({}, {{rectangle(0, 0, 1, 1), {}}}), 0.0);
}

TEST(Union, OfOverlappingSquaresIsOneRingOfEightVertices) {
  const auto united = union_of({{rectangle(0, 0, 2, 2), {}}, {rectangle(1, 1, 3, 3), {}}});
  ASSERT_EQ(united.size(), 1U);
  EXPECT_EQ(united[0].outer.size(), 8U);
  EXPECT_TRUE(united[0].holes.empty());
  EXPECT_DOUBLE_EQ(signed_area(united[0].outer), 7.0);
}

TEST(Union, OfSquaresSideBySideHasNoTraceOfTheirBorder) {
  const auto united = union_of({{rectangle(0, 0, 2, 1), {}}, {rectangle(2, 0, 4, 1), {}}});
  ASSERT_EQ(united.size(), 1U);
  EXPECT_THAT(united[0].outer,
              testing::ElementsAre(Point2(0, 0), Point2(4, 0), Point2(4, 1), Point2(0, 1)));
}

TEST(Union, KeepsHolesAndIslandsInThem) {
  const Polygon ring{rectangle(0, 0, 10, 10), {rectangle(2, 2, 8, 8)}};
  const auto united = union_of({ring, {rectangle(4, 4, 6, 6), {}}});
  ASSERT_EQ(united.size(), 2U);
  EXPECT_DOUBLE_EQ(area(united[0]), 64.0);
  ASSERT_EQ(united[0].holes.size(), 1U);
  EXPECT_DOUBLE_EQ(signed_area(united[0].holes[0]), -36.0);
  EXPECT_DOUBLE_EQ(area(united[1]), 4.0);
}

TEST(Union, OfFramesThatMakeALoopHasAHole) {
  const auto united = union_of({{rectangle(0, 0, 10, 1), {}},
                                {rectangle(0, 9, 10, 10), {}},
                                {rectangle(0, 0, 1, 10), {}},
                                {rectangle(9, 0, 10, 10), {}}});
  ASSERT_EQ(united.size(), 1U);
  EXPECT_EQ(united[0].holes.size(), 1U);
  EXPECT_DOUBLE_EQ(total_area(united), 36.0);
}

TEST(Union, SplitsRingsThatMeetInAVertex) {
  const auto united = union_of({{rectangle(0, 0, 1, 1), {}}, {rectangle(1, 1, 2, 2), {}}});
  EXPECT_EQ(united.size(), 2U);
  const Polygon touched_by_its_hole{rectangle(0, 0, 4, 4), {{{0, 0}, {1, 2}, {2, 1}}}};
  const auto pinched = union_of({touched_by_its_hole});
  ASSERT_EQ(pinched.size(), 1U);
  EXPECT_EQ(pinched[0].holes.size(), 1U);
  EXPECT_DOUBLE_EQ(area(pinched[0]), 14.5);
}

TEST(Union, CountsBothLobesOfABowTie) {
  const auto united = union_of({{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}}});
  ASSERT_EQ(united.size(), 2U);
  EXPECT_DOUBLE_EQ(total_area(united), 2.0);
}

TEST(Union, ANegativeLobeDoesNotCancelItsNeighbour) {
  const Ring bow_tie = {{0, 0}, {2, 2}, {2, 0}, {0, 2}};
  const auto united = union_of({{bow_tie, {}}, {rectangle(0, 0, 2, 2), {}}});
  EXPECT_DOUBLE_EQ(total_area(united), 4.0);
}

TEST(Union, CountsAreaCoveredTwiceByOneRingOnce) {
  Ring twice = rectangle(0, 0, 2, 2);
  for (const Point2& point : rectangle(0, 0, 2, 2)) twice.push_back(point);
  EXPECT_DOUBLE_EQ(total_area(union_of({{twice, {}}})), 4.0);
}

TEST(Union, DoesNotMindOrientationRepeatedVerticesOrSpikes) {
  const Ring reversed = {{0, 2}, {2, 2}, {2, 0}, {0, 0}};
  const Ring repeated = {{0, 0}, {0, 0}, {2, 0}, {2, 2}, {2, 2}, {0, 2}, {0, 0}};
  const Ring spiky = {{0, 0}, {2, 0}, {5, 0}, {2, 0}, {2, 2}, {1, 2}, {1, 1}, {1, 2}, {0, 2}};
  const std::vector<Polygon> expected = union_of({{rectangle(0, 0, 2, 2), {}}});
  for (const Ring& ring : {reversed, repeated, spiky}) {
    const auto united = union_of({{ring, {}}});
    ASSERT_EQ(united.size(), 1U);
    EXPECT_EQ(united[0].outer, expected[0].outer);
    EXPECT_TRUE(united[0].holes.empty());
  }
}

TEST(Union, OfRingsWithoutAreaIsEmpty) {
  const Ring point = {{1, 1}};
  const Ring line = {{0, 0}, {1, 0}, {2, 0}, {3, 0}};
  const Ring thinner_than_the_grid = {{0, 0}, {1, 0}, {1, 0.0004}, {0, 0.0004}};
  EXPECT_TRUE(union_of({{point, {}}, {line, {}}, {thinner_than_the_grid, {}}}).empty());
}

TEST(Union, LeavesNonFiniteVerticesOut) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const Ring ring = {{0, 0}, {nan, 1}, {2, 0}, {2, 2}, {inf, 5}, {0, 2}, {1e200, 3}};
  EXPECT_DOUBLE_EQ(total_area(union_of({{ring, {}}})), 4.0);
}

TEST(Union, KeepsMillimetresFarFromTheOrigin) {
  const double x = 4'400'000.0;
  const double y = 5'300'000.0;
  const auto united = union_of({{rectangle(x, y, x + 2.001, y + 1), {}}});
  EXPECT_NEAR(total_area(united), 2.001, 1e-6);
}

TEST(Overlap, CountsEachSetAsItsUnion) {
  const std::vector<Polygon> first = {{rectangle(0, 0, 2, 2), {}}, {rectangle(0, 0, 2, 2), {}}};
  const std::vector<Polygon> second = {{rectangle(1, 0, 3, 2), {}}, {rectangle(1, 1, 2, 3), {}}};
  EXPECT_DOUBLE_EQ(overlap_area(first, second), 2.0);
  EXPECT_DOUBLE_EQ(overlap_area(second, first), 2.0);
}

}  // namespace
}  // namespace roomatlas
