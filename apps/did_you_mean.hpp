// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace roomatlas::apps {

/// The names that a mistyped one was most likely meant to be, the nearest first, at most three:
/// letters left out, added, changed or swapped with their neighbours, and beginnings of names.
[[nodiscard]] std::vector<std::string> nearest(const std::string& typed,
                                               const std::vector<std::string>& names);

/// "; did you mean a or b?", or empty where no name is near.
[[nodiscard]] std::string did_you_mean(const std::string& typed,
                                       const std::vector<std::string>& names);

}  // namespace roomatlas::apps
