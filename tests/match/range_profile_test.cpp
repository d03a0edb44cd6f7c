// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../src/match/range_profile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace roomatlas {
namespace {

std::size_t bin_by_arc_tangent(const Point2& ray) {
  const double degree = degrees(std::atan2(ray.y(), ray.x())) + 180.0;
  return static_cast<std::size_t>(std::clamp(degree, 0.0, RangeProfile::kBins - 1.0));
}

/// Also on the degrees and just beside them, where the last digit decides, and in the origin.
TEST(RangeProfile, HasTheBinsOfTheArcTangent) {
  const RangeProfile profile(Point2::Zero(), {});
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any_deg(-180.0, 180.0);
  std::uniform_real_distribution<double> any_m(0.1, 30.0);
  for (int i = 0; i < 100'000; ++i) {
    const double whole_deg = std::floor(any_deg(random));
    for (const double degree :
         {any_deg(random), whole_deg, whole_deg + 0.5, whole_deg + 1e-13, whole_deg - 0.0101}) {
      const Point2 ray = any_m(random) * direction(radians(degree));
      ASSERT_EQ(profile.bin_of(ray), bin_by_arc_tangent(ray)) << degree;
    }
  }
  EXPECT_EQ(profile.bin_of(Point2::Zero()), bin_by_arc_tangent(Point2::Zero()));
  for (const Point2& ray : {Point2(1, 0), Point2(-1, 0), Point2(0, 1), Point2(0, -1)}) {
    EXPECT_EQ(profile.bin_of(ray), bin_by_arc_tangent(ray));
  }
}

}  // namespace
}  // namespace roomatlas
