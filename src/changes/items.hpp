// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "things.hpp"

namespace roomatlas::changes {

/// One thing that stands in one of the missions alone.
struct Item {
  Thing thing;
  Altered altered;
  Extent extent;  ///< of the whole thing
  Polygon outline;
};

/// The things that were altered: groups of cells that are one by the plans are one item.
[[nodiscard]] std::vector<Item> items_of(const std::vector<Altered>& altered,
                                         const FloorPlan& before, const FloorPlan& after,
                                         const std::vector<DoorPlace>& doors,
                                         const ChangeOptions& options);

/// What several groups say together.
void add(const Altered& more, Altered& to);

/// What was moved: places of an item that is gone and of a new one alike, the nearest first.
/// Each item is in one pair at most.
struct MovedPair {
  std::size_t gone = 0;
  std::size_t appeared = 0;
};
[[nodiscard]] std::vector<MovedPair> moved_pairs(const std::vector<Item>& items,
                                                 const ChangeOptions& options);

}  // namespace roomatlas::changes
