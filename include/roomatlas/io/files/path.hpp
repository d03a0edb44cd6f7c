// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace roomatlas {

using Path = std::filesystem::path;

/// The file that is meant where `file` is a symbolic link, also one whose file is missing; else
/// `file`. What replaces a file replaces that one, so that the link stays what it is.
[[nodiscard]] Path behind_links(const Path& file);

}  // namespace roomatlas
