// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/compare.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "evaluate/drives.hpp"
#include "roomatlas/evaluate/figures.hpp"
#include "roomatlas/evaluate/restamp.hpp"
#include "roomatlas/evaluate/time_ranges.hpp"

namespace roomatlas {
namespace {

using ::testing::HasSubstr;

std::vector<double> normal_values(std::size_t count) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal(20.0, 2.0);
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(normal(random));
  return values;
}

TEST(Bootstrap, OfIndependentErrorsIsAboutTwoStandardErrorsWide) {
  const std::vector<double> values = normal_values(2500);
  const ConfidenceInterval interval = bootstrap_mean(values, {});
  const Statistics s = statistics(values);
  const double half = 1.96 * s.standard_deviation / 50.0;
  EXPECT_NEAR(interval.mean, s.mean, 1e-12);
  EXPECT_NEAR(interval.low, s.mean - half, 0.25 * half);
  EXPECT_NEAR(interval.high, s.mean + half, 0.25 * half);
}

TEST(Bootstrap, IsWiderWhereNeighboursResembleEachOther) {
  std::vector<double> values = normal_values(2500);
  const double independent = bootstrap_mean(values, {}).high - bootstrap_mean(values, {}).low;
  std::sort(values.begin(), values.begin() + 50);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = values[i - i % 25];  // 25 alike
  const ConfidenceInterval interval = bootstrap_mean(values, {});
  EXPECT_GT(interval.high - interval.low, 3.0 * independent);
}

TEST(Bootstrap, GivesTheSameForTheSameSeedAndAnotherForAnother) {
  const std::vector<double> values = normal_values(100);
  EXPECT_EQ(bootstrap_mean(values, {}).low, bootstrap_mean(values, {}).low);
  EXPECT_NE(bootstrap_mean(values, {}).low, bootstrap_mean(values, {.seed = 2}).low);
}

TEST(Bootstrap, OfEqualErrorsHasNoWidthAndOfNothingNoEnds) {
  const ConfidenceInterval equal = bootstrap_mean(std::vector<double>(40, 3.0), {});
  EXPECT_NEAR(equal.low, 3.0, 1e-12);
  EXPECT_NEAR(equal.high, 3.0, 1e-12);
  EXPECT_TRUE(std::isnan(bootstrap_mean({}, {}).low));
  EXPECT_TRUE(std::isnan(bootstrap_mean({1.0, std::nan("")}, {}).high));
}

TEST(Restamp, GivesPosesTheTimestampOfTheNearestLoggerTime) {
  const std::vector<ClockReading> clock = {{0.10, 500.0}, {0.32, 500.2}, {0.50, 500.4}};
  const Restamped result =
      restamp({{0.101, {1, 0, 0}}, {0.33, {2, 0, 0}}, {7.0, {3, 0, 0}}}, clock);
  ASSERT_EQ(result.trajectory.size(), 2U);
  EXPECT_EQ(result.trajectory[1].timestamp_s, 500.2);
  EXPECT_NEAR(result.largest_difference_s, 0.01, 1e-12);
  ASSERT_EQ(result.issues.size(), 1U);
  EXPECT_THAT(result.issues[0].message, HasSubstr("1 of 3 poses"));
  EXPECT_TRUE(has_own_stamps({{500.0, {}}, {500.2, {}}}, clock));
  EXPECT_FALSE(has_own_stamps({{0.1, {}}}, clock));
}

TEST(Moved, IsTheTrajectoryOfAnotherPointOfTheRobot) {
  const Trajectory there = moved({{0.0, {1, 2, kPi / 2}}}, {0.3, 0.1, 0.0});
  EXPECT_NEAR(there[0].pose.x_m, 0.9, 1e-12);
  EXPECT_NEAR(there[0].pose.y_m, 2.3, 1e-12);
  EXPECT_EQ(shifted({{1.0, {}}}, 2.5)[0].timestamp_s, 3.5);
}

/// Times from one to another, `step_s` apart.
std::vector<double> times(double first_s, double last_s, double step_s) {
  std::vector<double> times_s;
  for (int i = 0; first_s + i * step_s <= last_s; ++i) times_s.push_back(first_s + i * step_s);
  return times_s;
}

TEST(ExplainMismatch, NamesBothRangesTheOffsetThatFitsAndTheFlag) {
  const std::string text = explain_mismatch(times(0.0, 1000.0, 0.25), times(1301.5, 2200.0, 7.0));
  EXPECT_THAT(text, HasSubstr("truth [1301.500, 2197.500] s"));
  EXPECT_THAT(text, HasSubstr("trajectory [0.000, 1000.000] s"));
  EXPECT_THAT(text, HasSubstr("--stamps-from"));
}

TEST(ExplainMismatch, SaysWhenNoOffsetFits) {
  const std::string text = explain_mismatch({0.0, 1.0, 2.0}, {500.0, 507.1, 519.7, 555.5, 556.1});
  EXPECT_THAT(text, HasSubstr("No offset fits"));
  EXPECT_THAT(text, HasSubstr("--time-offset 500.000"));
  EXPECT_THAT(text, HasSubstr("same recording?"));
}

TEST(FittingOffset, FindsTheOffsetOfIrregularTimesWhereverTheTruthBegins) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> gap(0.1, 3.0);
  std::uniform_real_distribution<double> late(-0.015, 0.015);
  std::vector<double> trajectory_s = {10.0};
  for (int i = 0; i < 800; ++i) trajectory_s.push_back(trajectory_s.back() + gap(random));
  std::vector<double> truth_s;
  for (std::size_t i = 123; i < 700; i += 3)
    truth_s.push_back(trajectory_s[i] + 976052857.25 + late(random));
  const auto fit = fitting_offset(trajectory_s, truth_s);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->offset_s, 976052857.25, 0.02);
  EXPECT_GT(fit->share, 0.95);
  EXPECT_FALSE(fitting_offset({}, truth_s));
  EXPECT_FALSE(fitting_offset(trajectory_s, {}));
}

TEST(ExplainMismatch, KnowsNanosecondsByTheirSizeOrByTheirLength) {
  EXPECT_THAT(explain_mismatch(times(1.6e18, 1.60001e18, 1e12), times(1.6e9, 1.60001e9, 1e3)),
              HasSubstr("trajectory's times look like nanoseconds"));
  EXPECT_THAT(explain_mismatch(times(5.0, 105.0, 1.0), times(6e9, 105e9, 1e9)),
              HasSubstr("truth's times look like nanoseconds"));
}

TEST(ExplainMismatch, SaysWhenTimesOverlapOrThereAreNone) {
  EXPECT_THAT(explain_mismatch({0.0, 10.0}, {5.0, 15.0}), HasSubstr("--match nearest"));
  EXPECT_THAT(explain_mismatch({0.0, 10.0}, {}), HasSubstr("truth is empty"));
}

TEST(CheckTrajectory, TellsNaNOnePoseWrongUnitsAndStepsBack) {
  const auto first = [](const Trajectory& trajectory) {
    const Issues issues = check_trajectory(trajectory, "x.tum");
    return issues.empty() ? std::string() : to_string(issues.front());
  };
  EXPECT_EQ(first(test::bent(5)), "");
  EXPECT_THAT(first({}), HasSubstr("x.tum: holds no pose"));
  EXPECT_THAT(first({{1.0, {}}}), HasSubstr("one pose only"));
  EXPECT_THAT(first({{1.0, {}}, {2.0, {std::nan(""), 0, 0}}}), HasSubstr("1 of 2 poses are NaN"));
  EXPECT_THAT(first({{1.6e18, {}}, {1.61e18, {}}}), HasSubstr("nanoseconds"));
  EXPECT_THAT(first({{5.0, {}}, {4.0, {}}}), HasSubstr("steps back 1 times"));
}

/// A truth with true poses and a relation every 5 poses.
TrajectoryTruth truth_of(const Trajectory& drive) {
  TrajectoryTruth truth{"drive", {}, drive};
  for (std::size_t i = 0; i + 10 < drive.size(); i += 5) {
    truth.relations.push_back({drive[i].timestamp_s, drive[i + 10].timestamp_s,
                               inverse(drive[i].pose) * drive[i + 10].pose});
  }
  return truth;
}

TEST(Compare, JudgesRunsOfDifferentMissionsEachByItsOwnTruth) {
  const Trajectory first = test::bent(400);
  const Trajectory second = test::bent(300, 900.0);
  const std::vector<roomatlas::Run> runs = {
      {"first", test::disturbed(first, 0.1, {}), first},
      {"second", test::disturbed(second, 0.01, {}), second},
      {"first again", test::disturbed(first, 0.01, {}), first}};
  const Comparison comparison = compare(runs, {"own", {}, {}}, {});
  EXPECT_EQ(comparison.true_poses, 400);
  const std::vector<Figure> all = figures(comparison);
  ASSERT_EQ(all.size(), 6U);  // APE and RPE
  EXPECT_EQ(all[0].of, 400);
  EXPECT_EQ(all[1].of, 300);
  EXPECT_EQ(all[1].covered, 300);
  EXPECT_FALSE(all[1].against_first);  // another mission: a difference would say nothing
  EXPECT_EQ(all[2].shared, 400);
  EXPECT_TRUE(all[2].against_first);
}

TEST(Compare, PutsRunsBelowEachOtherAndTheirDifferenceOverWhatBothCover) {
  const Trajectory drive = test::bent(400);
  Trajectory good = test::disturbed(drive, 0.01, {});
  good.resize(300);
  const std::vector<roomatlas::Run> runs = {{"bad", test::disturbed(drive, 0.1, {})},
                                            {"good", good}};
  const Comparison comparison = compare(runs, truth_of(drive), {});
  const std::vector<Figure> all = figures(comparison);
  ASSERT_GE(all.size(), 4U);
  EXPECT_EQ(all[0].run, "bad");
  EXPECT_EQ(all[1].run, "good");
  EXPECT_EQ(all[1].of, 78);
  EXPECT_EQ(all[1].covered, 58);
  EXPECT_EQ(all[1].shared, 58);
  EXPECT_FALSE(all[0].against_first);
  ASSERT_TRUE(all[1].against_first);
  EXPECT_LT(all[1].against_first->high, 0.0);

  const auto& bad = comparison.runs[0].relations->errors.errors;
  const auto& fine = comparison.runs[1].relations->errors.errors;
  double sum = 0.0;
  for (std::size_t i = 0; i < fine.size(); ++i) sum += fine[i].translation_m - bad[i].translation_m;
  EXPECT_NEAR(all[1].against_first->mean, sum / 58.0, 1e-12);
}

TEST(Compare, OfARunWithItselfFindsNoDifference) {
  const Trajectory drive = test::bent(200);
  const Trajectory run = test::disturbed(drive, 0.1, {1, 2, 3});
  const Comparison comparison = compare({{"a", run}, {"b", run}}, truth_of(drive), {});
  for (const Figure& figure : figures(comparison)) {
    if (!figure.against_first) continue;
    EXPECT_EQ(figure.against_first->low, 0.0) << figure.metric;
    EXPECT_EQ(figure.against_first->high, 0.0);
  }
}

TEST(Compare, SaysWhyARunHasNoFigures) {
  const Trajectory drive = test::bent(200);
  const Comparison comparison = compare({{"late", shifted(drive, 5000.0)}}, truth_of(drive), {});
  EXPECT_FALSE(comparison.has_figures());
  ASSERT_FALSE(comparison.runs[0].issues.empty());
  EXPECT_THAT(to_string(comparison.runs[0].issues[0]), HasSubstr("--time-offset -5000.000"));
}

TEST(Compare, DescribesWhatWasUsed) {
  EXPECT_EQ(describe({}, false), "equal to the microsecond");
  EXPECT_EQ(describe({TimeMatch::nearest, {}}, false), "nearest pose within 0.5 s");
  EXPECT_EQ(describe({TimeMatch::interpolate, {}}, false),
            "interpolated linearly across gaps of any length");
  EXPECT_THAT(describe({TimeMatch::interpolate, 2.0}, true), HasSubstr("up to 2 s, else carried"));
}

}  // namespace
}  // namespace roomatlas
