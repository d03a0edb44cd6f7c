// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <string>

namespace roomatlas::fuzz {

using Random = std::mt19937_64;

/// Changes bytes at one to a few places, as files are damaged and as attackers would: bits flipped,
/// stretches lost, doubled or put elsewhere, numbers of text and of bytes made extreme.
/// @param other another input, of which a stretch may be taken
/// @param most_bytes the result is cut there
[[nodiscard]] std::string mutated(std::string bytes, const std::string& other, Random& random,
                                  std::size_t most_bytes);

/// As large as it may be: one stretch of it, from a byte to all or from one comma to the next,
/// again and again at its place.
[[nodiscard]] std::string grown(const std::string& bytes, Random& random, std::size_t most_bytes);

}  // namespace roomatlas::fuzz
