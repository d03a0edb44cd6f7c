// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace roomatlas {

/// A text as the content of an HTML or XML element: `&`, `<` and `>` as entities, control codes,
/// which XML 1.0 does not know, left out.
[[nodiscard]] std::string markup_text(const std::string& text);

}  // namespace roomatlas
