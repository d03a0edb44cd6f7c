// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

#include <vector>

namespace roomatlas::planar {

/// Metres to whole millimetres about a local origin and back. A building far from its frame's
/// origin loses nothing.
class MillimetreGrid {
 public:
  MillimetreGrid() = default;
  /// @param around the origin is its lower left corner, rounded to a metre.
  explicit MillimetreGrid(const Box2& around);

  /// Units of the fine grid in a millimetre, on which crossings lie: as fine as coordinates in
  /// metres can tell apart where the building is, less two bits.
  [[nodiscard]] double fine() const { return fine_; }
  [[nodiscard]] Point2 to_grid(const Point2& point) const;
  [[nodiscard]] Point2 to_metres(const Point2& point_mm) const;
  [[nodiscard]] Ring to_metres(const Ring& ring_mm) const;
  [[nodiscard]] std::vector<Polygon> to_metres(const std::vector<Polygon>& polygons_mm) const;

 private:
  Point2 origin_mm_ = Point2::Zero();
  double fine_ = 0x1p16;  ///< the coarsest: right everywhere
};

/// False for NaN, for infinities, and for what is farther than the Earth is large: such a number
/// is a mistake, and would cost all other points their precision.
[[nodiscard]] bool is_plausible(const Point2& point_m);

/// What `on_grid` had to leave out.
struct Dropped {
  int implausible = 0;
  int repeated = 0;
};

/// The polygon on the grid, without implausible and consecutively repeated vertices.
[[nodiscard]] Polygon on_grid(const MillimetreGrid& grid, const Polygon& polygon_m,
                              Dropped* dropped = nullptr);

/// Extends the box by the polygon's plausible vertices.
void extend(Box2& box, const Polygon& polygon_m);

/// The ring with its vertices on whole millimetres, none of them repeated consecutively.
[[nodiscard]] Ring rounded(const Ring& ring_mm);
[[nodiscard]] Polygon rounded(const Polygon& polygon_mm);

}  // namespace roomatlas::planar
