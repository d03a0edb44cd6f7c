// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../src/correct/asr_headings.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "correct/corrected.hpp"

namespace roomatlas {
namespace {

constexpr int kStates = 90;

/// Three ASRs one after the other; odometry has them all look the same way, the walls of the second
/// lie at 4 degrees and those of the third at 10.
Measurements three_asrs() {
  Measurements measurements;
  measurements.ids = {1, 2, 3};
  measurements.odom_from_asr.assign(3, Pose2{});
  measurements.path_length_m.assign(3, 0.0);
  measurements.turning.assign(3, {});
  for (const double deg : {0.0, 4.0, 10.0}) {
    measurements.walls.emplace_back(WallDirection{radians(deg), 1.0, 10.0});
  }
  for (const std::size_t to : {1U, 2U}) measurements.driven.push_back({to - 1, to, {}});
  return measurements;
}

/// The corrections of three ASRs by going through all sequences of states.
std::array<double, 3> by_definition(const Measurements& measurements,
                                    const CorrectOptions& options) {
  const auto density = [](double off_rad, double sigma_rad) {
    return std::exp(-std::pow(wrap_quarter(off_rad) / sigma_rad, 2) / 2.0);
  };
  const auto share = [&](double at_rad, double sigma_rad) {  // of a state, of all states
    double sum = 0.0;
    for (int s = 0; s < kStates; ++s) sum += density(at_rad + radians(s), sigma_rad);
    return density(at_rad, sigma_rad) / sum;
  };
  const auto seen = [&](std::size_t asr, int state) {
    const WallDirection& wall = *measurements.walls[asr];
    return 0.3 / kStates +
           0.7 * share(wall.angle_rad + radians(state), wall_sigma_rad(wall, options));
  };
  const double drift_rad = options.odometry.heading.still;
  std::array<Point2, 3> sums{Point2::Zero(), Point2::Zero(), Point2::Zero()};
  for (int a = 0; a < kStates; ++a) {
    for (int b = 0; b < kStates; ++b) {
      const double until_b = seen(0, a) * share(radians(b - a), drift_rad) * seen(1, b);
      for (int c = 0; c < kStates; ++c) {
        const double weight = until_b * density(radians(c - b), drift_rad) * seen(2, c);
        sums[0] += weight * direction(4.0 * radians(a));
        sums[1] += weight * direction(4.0 * radians(b));
        sums[2] += weight * direction(4.0 * radians(c));
      }
    }
  }
  std::array<double, 3> corrections{};
  const auto mean = [&](std::size_t i) { return std::atan2(sums[i].y(), sums[i].x()) / 4.0; };
  for (std::size_t i = 0; i < 3; ++i) corrections[i] = wrap_quarter(mean(i) - mean(0));
  return corrections;
}

/// The surest that an option may have it, with walls that lie between two states.
TEST(AsrHeadings, OfWallsThatAreSurerThanTheStatesAreFineAreNumbers) {
  CorrectOptions options;
  options.wall_heading_deg = 0.01;
  options.wall_heading_deg_m = 0.0;
  Measurements measurements = three_asrs();
  for (auto& wall : measurements.walls) wall->angle_rad += radians(0.5);
  const AsrHeadings found = asr_headings(measurements, {}, options);
  EXPECT_TRUE(std::isfinite(found.log_evidence));
  for (const double correction : found.correction_rad) EXPECT_TRUE(std::isfinite(correction));
}

TEST(AsrHeadings, AreTheMeansOfAllSequencesOfStates) {
  CorrectOptions options;
  options.odometry.heading = {.still = radians(3.0)};
  const Measurements measurements = three_asrs();
  const AsrHeadings found = asr_headings(measurements, {}, options);
  const auto expected = by_definition(measurements, options);
  ASSERT_EQ(found.correction_rad.size(), 3U);
  EXPECT_EQ(found.correction_rad[0], 0.0);
  EXPECT_LT(found.correction_rad[2], radians(-1.0));
  for (std::size_t i = 1; i < 3; ++i) {  // moves below a millionth are left out
    EXPECT_NEAR(found.correction_rad[i], expected[i], 1e-5) << i;
  }
}

TEST(AsrHeadings, BeginAnewWhereOdometryDoesNotLead) {
  Measurements measurements = three_asrs();
  measurements.driven.pop_back();
  const AsrHeadings found = asr_headings(measurements, {}, {});
  EXPECT_LT(found.correction_rad[1], 0.0);
  EXPECT_EQ(found.correction_rad[2], 0.0);
}

/// Odometry whose heading drifts by so much a metre driven, twice round the block: the walls show
/// it.
std::vector<test::Visit> drifting(double deg_per_m) {
  auto visits = test::round_the_block(0.0);
  for (int i = 2; i < 6; ++i) visits.push_back(visits[static_cast<std::size_t>(i)]);
  const auto without_drift = test::chain_mission(visits);
  for (std::size_t i = 0; i < visits.size(); ++i) {
    visits[i].drift_deg = deg_per_m * path_length_m(without_drift[i]);
  }
  return visits;
}

TEST(EstimatedHabits, IsFoundWithItsSign) {
  for (const double deg_per_m : {-0.6, 0.0, 0.6}) {
    const Correction correction = test::corrected(test::chain_mission(drifting(deg_per_m)), {});
    EXPECT_EQ(correction.odometry.asrs, 10);
    EXPECT_NEAR(degrees(correction.odometry.habits.bias_rad_per_m), -deg_per_m, 0.3);
  }
}

TEST(EstimatedHabits, TakenOutLeavesTheTruth) {
  for (const auto model : {CorrectionModel::se2, CorrectionModel::rotation_only}) {
    const auto visits = drifting(0.6);
    const Correction correction =
        test::corrected(test::chain_mission(visits), test::options_of(model));
    const auto error = test::largest_error(placement_of(correction), test::true_placement(visits));
    EXPECT_LT(error.heading_deg, 1.0) << correction.model;
    EXPECT_LT(error.position_m, 0.3) << correction.model;
  }
}

TEST(EstimatedHabits, FoundBeforeADoorwayIsRecognisedGiveTheSameCorrection) {
  const auto asrs = test::chain_mission(drifting(0.6));
  const CorrectOptions options = test::options_of(CorrectionModel::se2);
  const EstimatedHabits habits = test::corrected(asrs, options).odometry;
  ASSERT_NE(habits.habits.bias_rad_per_m, 0.0);
  RoomGraph graph = build_graph(asrs);
  add_edge(graph, test::same_doorway(2, 6));
  const Correction again = correct(asrs, graph, options, {}, habits);
  const Correction anew = correct(asrs, graph, options);
  for (std::size_t i = 0; i < asrs.size(); ++i) {
    EXPECT_EQ(again.asrs[i].building_from_asr, anew.asrs[i].building_from_asr);
  }
  const Correction without = correct(asrs, graph, options, {}, EstimatedHabits{});
  EXPECT_NE(without.asrs.back().building_from_asr, anew.asrs.back().building_from_asr);
}

TEST(EstimatedHabits, IsNotEstimatedWithoutWallsFromFewAsrsOrWhenTurnedOff) {
  EXPECT_EQ(test::corrected(test::chain_mission(test::round_the_block(2.0)), {}).odometry.asrs, 0);
  CorrectOptions off;
  off.use_heading_bias = false;
  const auto asrs = test::chain_mission(drifting(0.6));
  EXPECT_EQ(test::corrected(asrs, off).odometry.habits, OdometryHabits());
  CorrectOptions without_walls;
  without_walls.use_wall_directions = false;
  const Correction correction = test::corrected(asrs, without_walls);
  EXPECT_EQ(correction.odometry.asrs, 0);
  for (const AsrCorrection& asr : correction.asrs) EXPECT_LT(asr.moved_m, 1e-9);
}

}  // namespace
}  // namespace roomatlas
