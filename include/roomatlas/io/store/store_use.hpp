// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace roomatlas {

// What other programs do with a store: a GeoPackage is opened, styled and added to in QGIS.

/// Throws InputError where another program writes to an SQLite file, or has it open in WAL mode, as
/// QGIS does: what it adds would be lost when the file is replaced. What a program that was killed
/// had committed beside the file is in it then. Does nothing where there is no such file.
void require_no_other_user(const std::filesystem::path& file);

/// Whether a file holds nothing that could be lost: no bytes, or an SQLite database without tables,
/// as a program leaves it that was killed while it made a store. Throws InputError when it cannot
/// be read.
[[nodiscard]] bool holds_nothing(const std::filesystem::path& file);

/// What others put into an SQLite file, in words: tables and views that no store has, further
/// columns of our tables, and styles of layers that are not as we write them. Rows that were added
/// to our own tables are not told from ours. Throws InputError when it cannot be read.
[[nodiscard]] std::vector<std::string> added_by_others(const std::filesystem::path& file);

}  // namespace roomatlas
