// SPDX-License-Identifier: GPL-3.0-or-later
// Things by the squares of the plane in which they lie: put in once, looked up often.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "roomatlas/core/floored.hpp"
#include "roomatlas/core/pose2.hpp"

namespace roomatlas {

struct Square {
  std::int32_t x = 0;
  std::int32_t y = 0;
  [[nodiscard]] bool operator==(const Square&) const = default;
};

/// The square of a side of `side_m` that a place lies in.
[[nodiscard]] inline Square square_of(const Point2& at, double side_m) {
  return {static_cast<std::int32_t>(floored(at.x() / side_m)),
          static_cast<std::int32_t>(floored(at.y() / side_m))};
}

/// Numbers of things by square, in each square in the order in which they came.
class SquareIndex {
 public:
  struct Entry {
    Square square;
    std::uint32_t item = 0;
  };

  /// @param entries of any order of squares
  explicit SquareIndex(const std::vector<Entry>& entries);

  /// What lies in a square.
  [[nodiscard]] std::span<const std::uint32_t> at(const Square& square) const {
    for (std::size_t i = slot_of(square);; i = (i + 1) & mask_) {
      const Slot& slot = slots_[i];
      if (slot.begin == slot.end) return {};
      if (slot.square == square) return {items_.data() + slot.begin, items_.data() + slot.end};
    }
  }

 private:
  /// Of a hash table with open addressing (Knuth 1973, section 6.4, algorithm L). An empty one is
  /// free.
  struct Slot {
    Square square;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
  };
  [[nodiscard]] std::size_t slot_of(const Square& square) const {
    constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15;  // Fibonacci hashing
    const std::uint64_t key = (std::uint64_t{static_cast<std::uint32_t>(square.x)} << 32U) |
                              static_cast<std::uint32_t>(square.y);
    return static_cast<std::size_t>((key * kGolden) >> 32U) & mask_;
  }

  std::size_t mask_ = 0;
  std::vector<Slot> slots_;
  std::vector<std::uint32_t> items_;
};

}  // namespace roomatlas
