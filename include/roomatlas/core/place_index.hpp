// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace roomatlas {

/// Finds what is near a place without asking everything: boxes in squares of a few metres, so that
/// the cost of a question does not grow with the building.
class PlaceIndex {
 public:
  /// Empty boxes are never found; what is not finite or spans very many squares always is.
  void add(std::size_t item, const Box2& box);
  /// Items whose squares a box touches, ascending, each once. All items that meet the box are
  /// among them; others may be.
  [[nodiscard]] std::vector<std::size_t> near(const Box2& box) const;

 private:
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> items_;  // by square
  std::vector<std::size_t> everywhere_;
  std::vector<std::size_t> all_;
};

/// The square around a point, as a box.
[[nodiscard]] Box2 box_around(const Point2& point, double reach_m);

}  // namespace roomatlas
