// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triangulation.hpp"

#include "roomatlas/core/geometry.hpp"

#include <vector>

namespace roomatlas::planar {

/// The plane cut into regions by the edges of polygons. Each region lies wholly inside or
/// outside each polygon, so that whatever is decided for it holds for all of its points.
/// Polygons may cross themselves and each other. Region 0 is the unbounded one.
class PlanarMap {
 public:
  static constexpr int kOutside = 0;

  /// A stretch of border with another region.
  struct Border {
    int region = 0;
    double length_mm = 0.0;
  };

  /// @param shapes_mm integer coordinates; rings of less than three vertices are ignored.
  explicit PlanarMap(const std::vector<Polygon>& shapes_mm);

  [[nodiscard]] int region_count() const { return static_cast<int>(regions_.size()); }
  /// Indices of the shapes over the region under the non-zero rule, ascending.
  [[nodiscard]] const std::vector<int>& covering(int region) const { return at(region).covering; }
  /// Zero for the unbounded region.
  [[nodiscard]] double area_mm2(int region) const { return at(region).area_mm2; }
  /// Each neighbour once, ascending.
  [[nodiscard]] const std::vector<Border>& borders(int region) const { return at(region).borders; }

  /// The regions of each group as polygons: outer rings counter-clockwise, holes clockwise, no
  /// ring meets itself even in a vertex; largest polygon first.
  /// @param group_of_region 0 to `groups` - 1, or -1 for what is left out. The unbounded region
  ///   always is.
  [[nodiscard]] std::vector<std::vector<Polygon>> trace(const std::vector<int>& group_of_region,
                                                        int groups) const;

 private:
  struct Region {
    double area_mm2 = 0.0;
    std::vector<int> covering;
    std::vector<Border> borders;
  };

  [[nodiscard]] const Region& at(int region) const {
    return regions_[static_cast<std::size_t>(region)];
  }
  void flood();
  void measure(const std::vector<Polygon>& shapes_mm);
  void find_borders();

  TriangleMesh mesh_;
  std::vector<int> region_of_triangle_;
  std::vector<Region> regions_;
};

/// The boundaries of groups of triangles as polygons; see `PlanarMap::trace`.
[[nodiscard]] std::vector<std::vector<Polygon>> trace_boundaries(
    const TriangleMesh& mesh, const std::vector<int>& group_of_triangle, int groups);

}  // namespace roomatlas::planar
