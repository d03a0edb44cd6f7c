// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "json_fwd.hpp"

namespace roomatlas::io {

/// Throws InputError, naming the file, for what is no JSON or nests too deep.
[[nodiscard]] Json parse_json(const std::string& text, const std::string& file);

/// Whether JSON nests deeper than any document of ours (64 levels). Who reads or writes such values
/// level by level would run out of stack: a file of a megabyte can nest a million times.
[[nodiscard]] bool nests_too_deep(std::string_view json);

}  // namespace roomatlas::io
