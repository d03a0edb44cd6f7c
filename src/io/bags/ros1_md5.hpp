// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace roomatlas::io {

/// The sum by which ROS 1 compares message types: MD5 of the definition without comments, constants
/// first, and types within replaced by their sums. "*", which fits any, where the definition is
/// empty or lacks a type.
[[nodiscard]] std::string ros1_md5(std::string_view type, std::string_view definition);

}  // namespace roomatlas::io
