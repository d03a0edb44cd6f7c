// SPDX-License-Identifier: GPL-3.0-or-later
#include "printable.hpp"

#include <cstdint>

#include "roomatlas/core/utf8.hpp"

namespace roomatlas::apps {
namespace {

/// Controls (C0, DEL, C1), line and paragraph separators, and what turns the direction of writing.
bool is_control(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7f && code <= 0x9f) || (code >= 0x2028 && code <= 0x202e) ||
         (code >= 0x2066 && code <= 0x2069) || code == 0x200e || code == 0x200f || code == 0x61c ||
         code == 0xfeff;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    const Utf8Character character = first_character(text);
    if (!character.is_whole || (is_control(character.code) && character.code <= 0xff)) {
      shown += fmt::format("\\x{:02x}", character.code);
    } else if (is_control(character.code)) {
      shown += fmt::format("\\u{:04x}", character.code);
    } else {
      shown += text.substr(0, character.bytes);
    }
    text.remove_prefix(character.bytes);
  }
  return shown;
}

std::string printable_lines(std::string_view text) {
  std::string shown;
  while (true) {
    const std::size_t end = text.find('\n');
    shown += printable(text.substr(0, end));
    if (end == std::string_view::npos) return shown;
    shown += '\n';
    text.remove_prefix(end + 1);
  }
}

}  // namespace roomatlas::apps
