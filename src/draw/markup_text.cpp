// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draw/markup_text.hpp"

namespace roomatlas {

std::string markup_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
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
        if (static_cast<unsigned char>(c) >= ' ') escaped += c;
    }
  }
  return escaped;
}

}  // namespace roomatlas
