// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "roomatlas/edit/edit.hpp"
#include "roomatlas/io/files/path.hpp"

namespace roomatlas {

/// Statements about a building as edits.json (docs/edits.md), and back.
[[nodiscard]] std::string edits_json(const std::vector<Edit>& edits);

/// @param file what the text is from, for messages
/// @throws InputError naming file, statement and field: what was found, what is expected
[[nodiscard]] std::vector<Edit> edits_of(const std::string& text, const std::string& file);

[[nodiscard]] std::vector<Edit> read_edits(const Path& file);

}  // namespace roomatlas
