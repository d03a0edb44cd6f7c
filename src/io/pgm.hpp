// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace roomatlas::io {

/// A grey picture, row after row from the top.
struct GreyPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint16_t> pixels;

  [[nodiscard]] std::uint16_t at(int column, int row) const {
    return pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(column)];
  }
};

/// Reads a binary PGM (P5, 8 or 16 bits), plain or gzip. Throws InputError naming the file.
[[nodiscard]] GreyPicture read_pgm(const std::filesystem::path& file);

}  // namespace roomatlas::io
