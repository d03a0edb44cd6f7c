// SPDX-License-Identifier: GPL-3.0-or-later
#include "square_index.hpp"

#include <bit>

namespace roomatlas {

SquareIndex::SquareIndex(const std::vector<Entry>& entries) {
  const std::size_t size = std::bit_ceil(2 * entries.size() + 1);  // at most half full
  mask_ = size - 1;
  slots_.resize(size);
  const auto find = [&](const Square& square) -> Slot& {
    std::size_t i = slot_of(square);
    while (slots_[i].end > 0 && slots_[i].square != square) i = (i + 1) & mask_;
    return slots_[i];
  };
  for (const Entry& entry : entries) {  // counts
    Slot& slot = find(entry.square);
    slot.square = entry.square;
    ++slot.end;
  }
  std::uint32_t begin = 0;
  for (Slot& slot : slots_) {
    if (slot.end == 0) continue;
    const std::uint32_t count = slot.end;
    slot.begin = begin;
    slot.end = begin + count;
    begin += count;
  }
  items_.resize(entries.size());
  std::vector<std::uint32_t> filled(slots_.size(), 0);
  for (const Entry& entry : entries) {
    const Slot& slot = find(entry.square);
    const auto at = static_cast<std::size_t>(&slot - slots_.data());
    items_[slot.begin + filled[at]++] = entry.item;
  }
}

}  // namespace roomatlas
