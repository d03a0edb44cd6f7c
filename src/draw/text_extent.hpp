// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace roomatlas::drawing {

/// The font of every drawing, and what stands in for it where it is not installed.
constexpr const char* kFontFamily = "DejaVu Sans, Verdana, sans-serif";

enum class Weight { normal, bold };

/// Height of capitals and digits, as a fraction of the font size.
constexpr double kCapHeight = 0.73;

/// Advance width of UTF-8 text in millimetres, without hinting or kerning: the same at every
/// resolution and on every machine. A character that the font does not have is as wide as the box
/// that stands for it.
[[nodiscard]] double text_width_mm(const std::string& text, double size_mm, Weight weight);

/// The text, or its beginning with an ellipsis, so that it is not wider than `width_mm`.
[[nodiscard]] std::string shortened(const std::string& text, double width_mm, double size_mm,
                                    Weight weight);

}  // namespace roomatlas::drawing
