// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "unpack.hpp"

#include <string>
#include <string_view>

namespace roomatlas::io {

/// Packs bytes in one piece. The same bytes give the same, with one release of the libraries.
[[nodiscard]] std::string pack(Packing packing, std::string_view bytes);

}  // namespace roomatlas::io
