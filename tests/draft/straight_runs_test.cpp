// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../src/draft/straight_runs.hpp"

#include <gtest/gtest.h>

namespace roomatlas {
namespace {

/// What is seen of a wall that looks along x, from `low_m` to `high_m` along y.
void add_wall(double x_m, double low_m, double high_m, std::vector<SurfacePoint>& surfaces) {
  for (double y_m = low_m; y_m < high_m; y_m += 0.02) {
    surfaces.push_back({{x_m, y_m}, 0.0, 1.0});
  }
}

TEST(StraightRuns, OfWallsThatAreFarApartAreThoseOfEachAlone) {
  std::vector<SurfacePoint> near;
  add_wall(3.0, 0.0, 2.0, near);
  add_wall(3.0, 2.4, 4.0, near);
  add_wall(4.5, 0.0, 1.0, near);
  const Point2 away{300000.0, -200000.0};  // a dense table of the bins would have 3e13
  std::vector<SurfacePoint> both = near;
  for (SurfacePoint surface : near) {
    surface.at += away;
    both.push_back(surface);
  }
  const std::vector<WallFace> alone = straight_runs(near, 0.0, {});
  ASSERT_EQ(alone.size(), 2U);
  EXPECT_NEAR(alone[0].offset_m, 3.0, 1e-9);
  EXPECT_EQ(alone[0].seen.size(), 2U);
  EXPECT_NEAR(alone[1].offset_m, 4.5, 1e-9);

  const std::vector<WallFace> all = straight_runs(both, 0.0, {});
  ASSERT_EQ(all.size(), 4U);
  for (const WallFace& face : alone) {
    for (const double moved : {0.0, 1.0}) {
      const auto found = std::find_if(all.begin(), all.end(), [&](const WallFace& other) {
        return std::abs(other.offset_m - face.offset_m - moved * away.x()) < 1e-6 &&
               std::abs(other.low_m() - face.low_m() - moved * away.y()) < 0.11;
      });
      ASSERT_NE(found, all.end()) << face.offset_m;
      EXPECT_NEAR(found->support_m(), face.support_m(), 0.21);  // bins begin elsewhere
    }
  }
}

}  // namespace
}  // namespace roomatlas
