// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "roomatlas/evaluate/evaluate.hpp"

namespace roomatlas {
namespace {

TEST(Statistics, OfAnOddCountHaveTheMiddleValueAsMedian) {
  const Statistics s = statistics({4.0, 1.0, 10.0});
  EXPECT_EQ(s.count, 3);
  EXPECT_DOUBLE_EQ(s.mean, 5.0);
  EXPECT_DOUBLE_EQ(s.median, 4.0);
  EXPECT_DOUBLE_EQ(s.maximum, 10.0);
  EXPECT_DOUBLE_EQ(s.standard_deviation, std::sqrt((1.0 + 16.0 + 25.0) / 3.0));
}

TEST(Statistics, OfAnEvenCountHaveTheMeanOfTheMiddleTwoAsMedian) {
  const Statistics s = statistics({8.0, 2.0, 4.0, 2.0});
  EXPECT_DOUBLE_EQ(s.median, 3.0);
  EXPECT_DOUBLE_EQ(s.mean, 4.0);
  EXPECT_DOUBLE_EQ(s.standard_deviation, std::sqrt(6.0));
}

TEST(Statistics, AreOfAbsoluteValues) {
  const Statistics s = statistics({-3.0, 1.0});
  EXPECT_DOUBLE_EQ(s.mean, 2.0);
  EXPECT_DOUBLE_EQ(s.maximum, 3.0);
}

TEST(Statistics, OfOneValueHaveNoDeviation) {
  const Statistics s = statistics({0.25});
  EXPECT_DOUBLE_EQ(s.mean, 0.25);
  EXPECT_DOUBLE_EQ(s.median, 0.25);
  EXPECT_DOUBLE_EQ(s.standard_deviation, 0.0);
}

TEST(Statistics, OfNothingAreNaN) {
  for (const Statistics& s : {statistics({}), Statistics{}}) {
    EXPECT_EQ(s.count, 0);
    EXPECT_TRUE(std::isnan(s.mean));
    EXPECT_TRUE(std::isnan(s.standard_deviation));
    EXPECT_TRUE(std::isnan(s.median));
    EXPECT_TRUE(std::isnan(s.maximum));
  }
}

TEST(Statistics, ShowABrokenMeasurement) {
  const Statistics s = statistics({1.0, std::numeric_limits<double>::quiet_NaN(), 0.0});
  EXPECT_EQ(s.count, 3);
  EXPECT_TRUE(std::isnan(s.mean));
  EXPECT_TRUE(std::isnan(s.maximum));
}

TEST(Statistics, DoNotDependOnTheOrderToTheLastBit) {
  std::mt19937 random(7);
  std::vector<double> values(101);
  for (double& value : values) value = static_cast<double>(random()) * 1e-7;
  const Statistics one = statistics(values);
  std::shuffle(values.begin(), values.end(), random);
  const Statistics other = statistics(values);
  EXPECT_EQ(one.mean, other.mean);
  EXPECT_EQ(one.standard_deviation, other.standard_deviation);
}

/// Two passes with more digits, and a selection in place of a sort.
TEST(StatisticsOfValues, AreTheSevenOfAnIndependentComputation) {
  std::vector<double> values;
  for (int i = 0; i < 1001; ++i) values.push_back(std::exp(std::sin(12.9898 * i) * 3.0));
  long double sum = 0.0L;
  long double squares = 0.0L;
  for (const double value : values) {
    sum += value;
    squares += static_cast<long double>(value) * value;
  }
  const long double count = 1001.0L;
  const long double mean = sum / count;
  long double deviations = 0.0L;
  for (const double value : values) deviations += (value - mean) * (value - mean);
  const auto rank_of = [&](double candidate) {
    return std::count_if(values.begin(), values.end(), [&](double v) { return v < candidate; });
  };
  const double median =
      *std::find_if(values.begin(), values.end(), [&](double v) { return rank_of(v) == 500; });

  const Statistics s = statistics(values);
  EXPECT_NEAR(s.mean, static_cast<double>(mean), 1e-9);
  EXPECT_NEAR(s.standard_deviation, static_cast<double>(std::sqrt(deviations / count)), 1e-9);
  EXPECT_NEAR(s.rmse, static_cast<double>(std::sqrt(squares / count)), 1e-9);
  EXPECT_NEAR(s.sse, static_cast<double>(squares), 1e-9);
  EXPECT_NEAR(s.mean_square, static_cast<double>(squares / count), 1e-9);
  EXPECT_EQ(s.median, median);
  EXPECT_EQ(s.minimum, *std::min_element(values.begin(), values.end()));
  EXPECT_EQ(s.maximum, *std::max_element(values.begin(), values.end()));
}

}  // namespace
}  // namespace roomatlas
