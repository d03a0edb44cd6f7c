// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "maps/cell_grid.hpp"

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>

namespace roomatlas::io {

/// A damaged or ill-meant header must not take all memory: no more pixels are read, and of a PNG,
/// whose pixels may take no bytes, an eighth of them.
inline constexpr std::int64_t kMostPixels = std::int64_t{1} << 28;

/// A grey picture as cells: row 0 is the lowest.
struct Picture {
  static constexpr int kTransparent = -1;  ///< no grey at all

  CellGrid<int> values;  ///< [0, white], or kTransparent
  int white = 255;       ///< the largest grey
};

/// A file's bytes; those of a gzip file are unpacked. Throws InputError.
/// @param most_bytes reading ends with the block that holds so many
[[nodiscard]] std::string read_unpacked(
    const std::filesystem::path& file,
    std::size_t most_bytes = std::numeric_limits<std::size_t>::max());

/// Whether a file's (unpacked) content begins like a picture that `parse_picture` knows.
[[nodiscard]] bool is_picture(const std::string& bytes);
[[nodiscard]] bool is_picture_file(const std::filesystem::path& file);

/// PGM (P2 and P5, 8 or 16 bits) or PNG; colours become the mean of red, green and blue, and a
/// pixel that is less than half opaque is transparent.
/// @param name of the file, for messages
/// Throws InputError when it is neither, is cut short, or has more pixels than `kMostPixels`
/// allows.
[[nodiscard]] Picture parse_picture(const std::string& bytes, const std::string& name);

/// The two kinds; `parse_picture` chooses.
[[nodiscard]] Picture parse_pgm(const std::string& bytes, const std::string& name);
[[nodiscard]] Picture parse_png(const std::string& bytes, const std::string& name);

}  // namespace roomatlas::io
