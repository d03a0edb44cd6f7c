// SPDX-License-Identifier: GPL-3.0-or-later
// Bits that look random and are decided by a number: SplitMix64 (Steele, Lea and Flood 2014).
#pragma once

#include <cstdint>

namespace roomatlas {

/// Its last step alone: 0 stays 0.
[[nodiscard]] constexpr std::uint64_t finalised_bits(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9U;
  bits = (bits ^ (bits >> 27U)) * 0x94D049BB133111EBU;
  return bits ^ (bits >> 31U);
}

/// Neighbouring numbers, 0 among them, are spread.
[[nodiscard]] constexpr std::uint64_t mixed_bits(std::uint64_t number) {
  return finalised_bits(number + 0x9E3779B97F4A7C15U);
}

}  // namespace roomatlas
