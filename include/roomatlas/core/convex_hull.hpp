// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/core/geometry.hpp"

namespace roomatlas {

/// The smallest convex ring around some points, counter-clockwise (A. M. Andrew, "Another efficient
/// algorithm for convex hulls in two dimensions", 1979). Of fewer than three points, or points on
/// one line, a ring without area; empty for none.
[[nodiscard]] Ring convex_hull(std::vector<Point2> points);

}  // namespace roomatlas
