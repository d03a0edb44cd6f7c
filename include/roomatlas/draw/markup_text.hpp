// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace roomatlas {

/// What XML 1.0 can hold of a text: control codes, which it does not know, are left out, and U+FFFD
/// stands in the place of bytes that are not UTF-8.
[[nodiscard]] std::string xml_characters(std::string_view text);

/// A text as the content of an HTML or XML element: those characters, with `&`, `<` and `>` as
/// entities.
[[nodiscard]] std::string markup_text(const std::string& text);

}  // namespace roomatlas
