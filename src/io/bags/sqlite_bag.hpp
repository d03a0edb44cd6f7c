// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bag_reader.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace roomatlas::io {

inline constexpr std::string_view kSqliteMagic{"SQLite format 3\0", 16};

/// Reads a file of rosbag2's SQLite storage, of any version. Nothing is written beside it: it is
/// opened as one that nobody changes. Returns null where it is another database; throws InputError
/// where it cannot be read. `shown_name` is its name in messages.
[[nodiscard]] std::unique_ptr<BagReader> open_sqlite_bag(const std::filesystem::path& file,
                                                         const std::string& shown_name);

}  // namespace roomatlas::io
