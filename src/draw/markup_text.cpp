// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draw/markup_text.hpp"

#include "roomatlas/core/utf8.hpp"

namespace roomatlas {

std::string xml_characters(std::string_view text) {
  std::string kept;
  while (!text.empty()) {
    const Utf8Character character = first_character(text);
    const std::uint32_t code = character.code;
    const bool is_control = code < 0x20 || (code >= 0x7f && code <= 0x9f);
    const bool is_none = code == 0xfffe || code == 0xffff;
    if (!character.is_whole) {
      kept += "\xef\xbf\xbd";
    } else if (!is_control && !is_none) {
      kept += text.substr(0, character.bytes);
    }
    text.remove_prefix(character.bytes);
  }
  return kept;
}

std::string markup_text(const std::string& text) {
  std::string escaped;
  for (const char c : xml_characters(text)) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

}  // namespace roomatlas
