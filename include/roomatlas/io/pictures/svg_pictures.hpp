// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "roomatlas/io/files/path.hpp"

namespace roomatlas {

/// Whether the plug-in roomatlas-pictures is there, without which there are none of the pictures
/// below.
[[nodiscard]] bool has_pictures();

/// Renders an SVG document to a PNG. Throws InputError when it cannot be written, UsageError
/// without the plug-in.
void write_png(const Path& file, const std::string& svg, double dots_per_inch);

/// Renders an SVG document to a PDF of one page, at the size on paper that the document states;
/// text stays text. Throws as `write_png` does.
/// @param date of the mission, YYYY-MM-DD, becomes the date of creation; empty: 1970-01-01
void write_pdf(const std::filesystem::path& file, const std::string& svg, const std::string& title,
               const std::string& date);

}  // namespace roomatlas
