// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

namespace roomatlas::bench {

/// Draws for one case of a run; the same seed and number give the same on every machine.
class Draw {
 public:
  Draw(std::uint64_t seed, std::uint64_t number);

  /// [0, 1).
  [[nodiscard]] double share();
  [[nodiscard]] double between(double low, double high);
  /// As likely to double as to halve.
  [[nodiscard]] double between_by_ratio(double low, double high);
  [[nodiscard]] int whole(int low, int high);  ///< both included
  [[nodiscard]] bool happens(double probability);
  [[nodiscard]] double either_sign(double value) { return happens(0.5) ? value : -value; }

  template <typename Value>
  [[nodiscard]] const Value& one_of(const std::vector<Value>& values) {
    return values[static_cast<std::size_t>(whole(0, static_cast<int>(values.size()) - 1))];
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace roomatlas::bench
