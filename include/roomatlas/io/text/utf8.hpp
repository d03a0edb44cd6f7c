// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace roomatlas {

/// The text with U+FFFD in the place of what is not UTF-8: names of files are bytes, and what is
/// written (JSON, SVG, GeoPackage) is not.
[[nodiscard]] std::string as_utf8(const std::string& bytes);

}  // namespace roomatlas
