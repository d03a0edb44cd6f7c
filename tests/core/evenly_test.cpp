// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/evenly.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace roomatlas {
namespace {

TEST(KeepEvenly, LeavesSoManyInTheirOrderAndNoLongGap) {
  for (const std::size_t count : {0U, 1U, 5U, 6U, 7U, 40U, 1000U}) {
    for (const std::size_t most : {1U, 2U, 6U, 32U}) {
      std::vector<int> items(3 + count);
      std::iota(items.begin(), items.end(), -3);  // three that stay, then 0, 1, 2 ...
      keep_evenly(most, items, 3);
      ASSERT_EQ(items.size(), 3 + std::min(count, most));
      EXPECT_TRUE(std::equal(items.begin(), items.begin() + 3, std::vector{-3, -2, -1}.begin()));
      EXPECT_TRUE(std::adjacent_find(items.begin(), items.end(), std::greater_equal<>()) ==
                  items.end());
      const int gap = static_cast<int>(std::max<std::size_t>(1, (count + most - 1) / most));
      for (std::size_t i = 4; i < items.size(); ++i) EXPECT_LE(items[i] - items[i - 1], gap);
    }
  }
}

}  // namespace
}  // namespace roomatlas
