// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace roomatlas::io {

/// The place of a file that another one names, in or below that one's folder. A name that leads out
/// of it ("/etc/passwd", "../x") may be a stranger's wish or another machine's path: the file of
/// that name in the folder itself is meant then.
[[nodiscard]] std::filesystem::path place_inside(const std::filesystem::path& folder,
                                                 const std::string& named);

}  // namespace roomatlas::io
