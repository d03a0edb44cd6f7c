// SPDX-License-Identifier: GPL-3.0-or-later
// What numbers on the command line and in its file must be.
#pragma once

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cmath>
#include <string>

namespace roomatlas::apps {

/// As CLI::Range, which lets NaN pass because it is neither below nor above a limit, and writes a
/// whole number of seven digits in a way that it does not read.
[[nodiscard]] inline CLI::Validator within(double low, double high) {
  const auto check = [low, high](std::string& text) {
    double value = 0.0;
    const bool fits = CLI::detail::lexical_cast(text, value) && low <= value && value <= high;
    return fits ? "" : fmt::format("Value {} not in range {} to {}", text, low, high);
  };
  return {check, fmt::format("FLOAT in [{} - {}]", low, high)};
}

/// Any number but NaN and the infinities; the help does not mention it.
[[nodiscard]] inline CLI::Validator finite() {
  const auto check = [](std::string& text) {
    double value = 0.0;
    const bool is_finite = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
    return is_finite ? std::string() : "Value " + text + " is not a finite number";
  };
  return {check, ""};
}

}  // namespace roomatlas::apps
