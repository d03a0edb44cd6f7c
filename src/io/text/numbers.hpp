// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace roomatlas::io {

/// The whole token as a number, whatever the locale; also "nan" and "inf". Nothing when it is not
/// a number or does not fit a double.
[[nodiscard]] std::optional<double> parse_number(std::string_view token);

/// The whole token as a range. One that does not fit a float becomes infinite, which means "no
/// measurement". Nothing when it is not a number.
[[nodiscard]] std::optional<float> parse_range(std::string_view token);

/// The number as a message shows it: six digits, with an exponent where it is long.
[[nodiscard]] std::string shown(double value);

/// Appends the shortest decimal text without exponent that reads back to the same value.
void append_number(std::string& text, double value);
void append_number(std::string& text, float value);

}  // namespace roomatlas::io
