// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace roomatlas {

/// Leaves at most so many items, evenly over all of them and in their order.
/// @param first those before it stay as they are
template <typename Item>
void keep_evenly(std::size_t most, std::vector<Item>& items, std::size_t first = 0) {
  const std::size_t count = items.size() - first;
  if (count <= most) return;
  for (std::size_t k = 0; k < most; ++k) {
    items[first + k] = items[first + (2 * k + 1) * count / (2 * most)];
  }
  items.resize(first + most);
}

}  // namespace roomatlas
