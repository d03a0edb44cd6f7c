// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>

namespace roomatlas::io {

// Packed data may unpack to far more than anybody recorded, to fill memory, disk and time. What was
// measured and written packs by 3 to 60 times, a robot that stands still by some hundreds.

/// So much is always unpacked.
inline constexpr std::uint64_t kAlwaysUnpacked_bytes = std::uint64_t{1} << 26;
/// Beyond it: bytes from a byte.
inline constexpr std::uint64_t kMostGrowth = 256;
/// Of a whole recording, which is streamed.
inline constexpr std::uint64_t kMostGrowthStreamed = 1024;

/// How much `packed_bytes` may unpack to.
[[nodiscard]] constexpr std::uint64_t most_unpacked_bytes(std::uint64_t packed_bytes,
                                                          std::uint64_t growth) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  if (packed_bytes > (kMost - kAlwaysUnpacked_bytes) / growth) return kMost;
  return kAlwaysUnpacked_bytes + growth * packed_bytes;
}

}  // namespace roomatlas::io
