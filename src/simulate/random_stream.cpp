// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_stream.hpp"

#include "roomatlas/core/mixed_bits.hpp"
#include "roomatlas/core/pose2.hpp"

#include <cmath>
#include <utility>

namespace roomatlas {
namespace {

/// FNV-1a.
std::uint64_t hash_of(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return hash;
}

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::string_view purpose)
    : engine_(mixed_bits(mixed_bits(seed) ^ hash_of(purpose))) {}

double RandomStream::uniform() { return static_cast<double>(engine_() >> 11U) * 0x1.0p-53; }

double RandomStream::normal() {
  if (spare_normal_) return *std::exchange(spare_normal_, std::nullopt);
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));  // 1 - u is in (0, 1]
  const double angle_rad = 2.0 * kPi * uniform();
  spare_normal_ = radius * std::sin(angle_rad);
  return radius * std::cos(angle_rad);
}

}  // namespace roomatlas
