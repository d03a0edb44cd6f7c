// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

namespace roomatlas::drawing {

/// Characters from this one to the next run's are as wide as each other.
struct WidthRun {
  char32_t first = 0;
  std::uint16_t width = 0;  ///< advance, in thousandths of the font's size
};

/// Of DejaVu Sans, in the order of the characters; the first run begins with the blank. Written
/// when the project is built, by cmake/font_widths.cpp from the font's files.
[[nodiscard]] std::span<const WidthRun> normal_widths();
[[nodiscard]] std::span<const WidthRun> bold_widths();

}  // namespace roomatlas::drawing
