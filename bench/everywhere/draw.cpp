// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw.hpp"

#include <cmath>

namespace roomatlas::bench {

Draw::Draw(std::uint64_t seed, std::uint64_t number)
    : engine_(seed * 0x9e3779b97f4a7c15U ^ (number + 1) * 0xbf58476d1ce4e5b9U) {
  engine_.discard(16);  // neighbouring seeds begin alike
}

double Draw::share() { return static_cast<double>(engine_() >> 11U) * 0x1.0p-53; }

double Draw::between(double low, double high) { return low + (high - low) * share(); }

double Draw::between_by_ratio(double low, double high) {
  return low * std::pow(high / low, share());
}

int Draw::whole(int low, int high) {
  return low + static_cast<int>(share() * static_cast<double>(high - low + 1));
}

bool Draw::happens(double probability) { return share() < probability; }

}  // namespace roomatlas::bench
