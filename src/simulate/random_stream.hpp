// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <string_view>

namespace roomatlas {

/// A random stream for one purpose, so that drawing more numbers for one (another sensor, say)
/// leaves every other as it was. The distributions are written out here because those of the
/// standard library differ from one library to the next.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::string_view purpose);

  /// Uniform in [0, 1), all 53 bits.
  [[nodiscard]] double uniform();
  /// Mean 0, standard deviation 1 (Box and Muller, 1958).
  [[nodiscard]] double normal();

 private:
  std::mt19937_64 engine_;
  std::optional<double> spare_normal_;
};

}  // namespace roomatlas
