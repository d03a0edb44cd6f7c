// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/crc32.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstddef>
#include <random>
#include <span>
#include <string_view>
#include <vector>

namespace roomatlas::test {
namespace {

TEST(Crc32, IsZlibsForEveryLengthAndPlace) {
  std::mt19937 random(5);
  std::vector<std::byte> bytes(5000);
  for (std::byte& byte : bytes) byte = static_cast<std::byte>(random());
  const std::span<const std::byte> all(bytes);
  for (std::size_t size = 0; size < 4000; size += size < 600 ? 1 : 61) {
    const std::span<const std::byte> some = all.subspan(size % 17, size);
    const auto before = static_cast<std::uint32_t>(size % 3 == 0 ? 0 : random());
    const auto by_zlib = static_cast<std::uint32_t>(
        crc32_z(before, reinterpret_cast<const Bytef*>(some.data()), some.size()));
    ASSERT_EQ(io::crc32_of(some, before), by_zlib) << size;
  }
}

TEST(Crc32, OfNineDigitsIsWhatItsCatalogueSays) {
  constexpr std::string_view kDigits = "123456789";
  EXPECT_EQ(io::crc32_of(std::as_bytes(std::span(kDigits))), 0xCBF43926U);
}

}  // namespace
}  // namespace roomatlas::test
