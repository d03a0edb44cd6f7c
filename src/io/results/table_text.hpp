// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace roomatlas::io {

/// A field of a CSV file, quoted where it must be (RFC 4180).
[[nodiscard]] std::string csv_text(const std::string& text);

/// Appends a comma and the number in its shortest form that reads back to the same double; nothing
/// behind the comma where it is not finite.
void add_csv(std::string& line, double value);

/// Text with LaTeX's own characters escaped.
[[nodiscard]] std::string latex_text(const std::string& text);

/// Three figures after the first one that counts, so that 0.0581 and 6.50 both read well; "--"
/// where it is not finite.
[[nodiscard]] std::string short_number(double value);

}  // namespace roomatlas::io
