// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

#include <array>
#include <cstdio>
#include <string>

namespace roomatlas {

/// For messages: two decimals.
inline std::string number_text(double value) {
  std::array<char, 400> text{};  // the largest double has 309 digits
  const int length = std::snprintf(text.data(), text.size(), "%.2f", value);
  return {text.data(), static_cast<std::size_t>(length)};
}

/// For messages: `(1.20, 3.40)`.
inline std::string place_text(const Point2& point) {
  return "(" + number_text(point.x()) + ", " + number_text(point.y()) + ")";
}

}  // namespace roomatlas
