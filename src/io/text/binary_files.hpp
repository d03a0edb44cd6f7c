// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace roomatlas::io {

/// What a file is that is no text, by its first bytes, with the remedy; empty where it is none of
/// those that people have. `is_packed`: they are what gzip packed.
[[nodiscard]] std::string binary_kind(std::string_view beginning, bool is_packed);

}  // namespace roomatlas::io
