// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace roomatlas {

/// A character of a text that should be UTF-8 (RFC 3629).
struct Utf8Character {
  std::uint32_t code = 0;
  std::size_t bytes = 1;  ///< that it takes
  bool is_whole = false;  ///< false: the byte is part of no character, and `code` is the byte
};

/// @param text not empty
[[nodiscard]] Utf8Character first_character(std::string_view text);

}  // namespace roomatlas
