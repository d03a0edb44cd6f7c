// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "plugins/vector_file.hpp"
#include "roomatlas/io/files/path.hpp"

namespace roomatlas::io {

/// Writes the file, or the files of a format that has several, by the plug-in roomatlas-gdal; each
/// appears when it is whole. Throws UsageError without the plug-in and for a format that its GDAL
/// cannot write, InputError when writing fails.
/// @returns the files' names below the folder
std::vector<std::string> write_vector_file(const Path& folder, const VectorFile& file);

}  // namespace roomatlas::io
