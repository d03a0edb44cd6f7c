// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/core/geometry.hpp"

namespace roomatlas {

/// The union of polygons under the non-zero rule (each polygon on its own), as disjoint polygons
/// with holes, outer rings counter-clockwise, largest first.
[[nodiscard]] std::vector<Polygon> union_of(const std::vector<Polygon>& polygons);

/// What the first polygons cover and none of the second do, likewise.
[[nodiscard]] std::vector<Polygon> difference_of(const std::vector<Polygon>& first,
                                                 const std::vector<Polygon>& second);

/// Area in square metres that both sets cover (each set counted as its union).
[[nodiscard]] double overlap_area(const std::vector<Polygon>& first,
                                  const std::vector<Polygon>& second);

}  // namespace roomatlas
