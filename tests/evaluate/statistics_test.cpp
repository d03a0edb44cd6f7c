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

}  // namespace
}  // namespace roomatlas
