// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/sonar/contradiction.hpp"

#include <gtest/gtest.h>

#include "support/sonar_world.hpp"

namespace roomatlas {
namespace {

/// Up and down a corridor of 1.8 m, twice.
struct Mission {
  std::vector<Pose2> truth = test::drive_along({{0, 0}, {12, 0}, {0, 0}, {12, 0}});
  std::vector<double> path_m = test::path_lengths(truth);
  std::vector<RangeReading> readings = test::readings_along(
      test::walls_along({{-1, -0.9}, {13, -0.9}, {13, 0.9}, {-1, 0.9}}, true), truth, 0.0);

  [[nodiscard]] Contradiction judged(const std::vector<Pose2>& poses) const {
    const auto segments = wall_segments(readings, poses, path_m, {});
    return contradiction_of(readings, poses, path_m, segments, {});
  }
};

TEST(Contradiction, OfTruePosesIsSmall) {
  const Mission mission;
  const Contradiction contradiction = mission.judged(mission.truth);
  EXPECT_GT(contradiction.confirmed_m, 20.0);
  EXPECT_LT(contradiction.share(), 0.05);
}

TEST(Contradiction, OfAHeadingThatSlippedByNinetyDegreesIsLarge) {
  const Mission mission;
  std::vector<Pose2> slipped = mission.truth;
  const std::size_t from = slipped.size() / 2;
  const Pose2 turned = mission.truth[from] * Pose2{0, 0, kPi / 2} * inverse(mission.truth[from]);
  for (std::size_t i = from; i < slipped.size(); ++i) slipped[i] = turned * slipped[i];
  EXPECT_GT(mission.judged(slipped).share(), mission.judged(mission.truth).share() + 0.05);
}

TEST(Contradiction, IsUnknownWhereNothingWasSeenTwice) {
  const auto truth = test::drive_along({{0, 0}, {4, 0}});
  const auto path_m = test::path_lengths(truth);
  const auto readings =
      test::readings_along(test::walls_along({{-9, 1}, {9, 1}}, false), truth, 0.0);
  const auto segments = wall_segments(readings, truth, path_m, {});
  EXPECT_FALSE(segments.empty());
  EXPECT_LT(contradiction_of(readings, truth, path_m, segments, {}).share(), 0.0);
}

}  // namespace
}  // namespace roomatlas
