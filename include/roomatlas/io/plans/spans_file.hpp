// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/evaluate/spans.hpp"

#include <filesystem>
#include <vector>

namespace roomatlas {

/// Tape-measure spans: `name, from, to, metres` a line; docs/formats.md has the ends. Throws
/// InputError naming file, line and field.
[[nodiscard]] std::vector<Span> read_spans(const std::filesystem::path& file);

}  // namespace roomatlas
