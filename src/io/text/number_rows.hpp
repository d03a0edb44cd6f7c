// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace roomatlas::io {

/// Reads a text file (plain or gzip) of which each line is a row of numbers. Blank lines and what
/// follows a `#` are skipped.
/// @param columns their names, for messages
/// @param use called with as many finite numbers as there are columns, line after line; what it
///   returns is what is wrong with the row, or empty
/// Throws InputError naming file, line and column when the file cannot be read, or a row has
/// another number of fields, something that is not a finite number, or is refused.
void read_number_rows(const std::filesystem::path& file, const std::vector<std::string>& columns,
                      const std::function<std::string(std::span<const double>)>& use);

}  // namespace roomatlas::io
