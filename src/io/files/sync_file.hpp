// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace roomatlas {

/// Asks the operating system to put a file's or directory's content on the disk. Does nothing
/// where that is not possible: it only narrows what a power failure can lose.
void sync_to_disk(const std::filesystem::path& path);

}  // namespace roomatlas
