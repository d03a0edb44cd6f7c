// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace roomatlas::io {

/// Of `names` the one that takes the fewest letters to change, add or take away (the edit distance;
/// capitals count as small letters) to become `name`; of equals the first. Empty where there are no
/// names.
[[nodiscard]] std::string nearest_name(std::string_view name,
                                       const std::vector<std::string>& names);

}  // namespace roomatlas::io
