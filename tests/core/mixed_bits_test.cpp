// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/mixed_bits.hpp"

#include <gtest/gtest.h>

namespace roomatlas {
namespace {

/// The first numbers of the published generator from the seeds 0 and 1234567.
TEST(MixedBits, AreTheFirstNumbersOfSplitMix64) {
  EXPECT_EQ(mixed_bits(0), 0xE220A8397B1DCDAFU);
  EXPECT_EQ(mixed_bits(1234567), 6457827717110365317U);
}

}  // namespace
}  // namespace roomatlas
