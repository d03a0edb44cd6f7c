// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/merge/merge.hpp"

namespace roomatlas {

template <typename Visit>
void for_each_edge(const Ring& ring, Visit visit) {
  for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
}

template <typename Visit>
void for_each_ring(const std::vector<PlacedOutline>& outlines, Visit visit) {
  for (const PlacedOutline& placed : outlines) {
    visit(placed.outline.outer);
    for (const Ring& hole : placed.outline.holes) visit(hole);
  }
}

}  // namespace roomatlas
