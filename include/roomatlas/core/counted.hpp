// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <string>

namespace roomatlas {

/// A count and its noun: "1 room", "2 rooms", "0 bodies".
/// @param many the plural where it is not the noun with an s
[[nodiscard]] std::string counted(std::integral auto count, const std::string& one,
                                  const std::string& many = "") {
  const std::string number = std::to_string(count) + ' ';
  return count == 1 ? number + one : number + (many.empty() ? one + 's' : many);
}

}  // namespace roomatlas
