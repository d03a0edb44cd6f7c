// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/packed.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <limits>
#include <vector>

namespace roomatlas {
namespace {

template <typename Value>
Value there_and_back(const Value& value) {
  return unpacked<Value>(packed(value));
}

TEST(Packed, KeepsEveryBitOfANumber) {
  for (const double value : {0.1, -0.0, 1e-310, std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(packed(there_and_back(value)), packed(value));
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(packed(there_and_back(nan)), packed(nan));
}

TEST(Packed, KeepsSequencesOptionalsPosesAndMatrices) {
  const std::vector<Pose2> poses = {{1.0, 2.0, 3.0}, {-0.5, 1e300, 0.0}};
  EXPECT_EQ(there_and_back(poses), poses);
  EXPECT_EQ(there_and_back(std::deque<int>{3, 1, 2}), (std::deque<int>{3, 1, 2}));
  EXPECT_EQ(there_and_back(std::optional<double>()), std::nullopt);
  EXPECT_EQ(there_and_back(std::optional<double>(2.5)), 2.5);
  Eigen::Matrix2d matrix;
  matrix << 1.0, 2.0, 3.0, 4.0;
  EXPECT_EQ(there_and_back(matrix), matrix);
  EXPECT_EQ(there_and_back(Point2(5.0, 6.0)), Point2(5.0, 6.0));
}

TEST(Unpacker, RefusesBytesThatEndTooEarlyAndCountsThatCannotBe) {
  const std::string bytes = packed(std::vector<double>{1.0, 2.0});
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_THROW((void)unpacked<std::vector<double>>(bytes.substr(0, length)), std::logic_error);
  }
  EXPECT_THROW((void)unpacked<std::vector<double>>(packed(std::size_t{1} << 60)), std::logic_error);
}

}  // namespace
}  // namespace roomatlas
