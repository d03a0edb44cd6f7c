// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/planar/plane_graph.hpp"

#include "roomatlas/core/geometry.hpp"

#include <span>
#include <vector>

namespace roomatlas::planar {

/// When a polygon of the input covers a point.
enum class FillRule {
  nonzero,   ///< the outer ring winds around it and no hole does, whichever way the rings run
  positive,  ///< all rings together wind around it more often counter-clockwise than clockwise
};

/// The plane cut into regions by the edges of polygons. Each region lies wholly inside or
/// outside each polygon, so that whatever is decided for it holds for all of its points.
/// Polygons may cross themselves and each other. Region 0 is the unbounded one.
class PlanarMap {
 public:
  static constexpr int kOutside = PlaneGraph::kOutside;

  /// A stretch of border with another region.
  struct Border {
    int region = 0;
    double length_mm = 0.0;
  };

  /// @param shapes_mm rings of less than three vertices are ignored. Vertices are rounded to the
  ///   grid of an `EdgeSet`.
  /// @param fine units of that grid in a millimetre.
  /// @param first_positive shapes from this one on count under the positive rule; -1: none.
  PlanarMap(const std::vector<Polygon>& shapes_mm, double fine, int first_positive = -1);

  [[nodiscard]] int region_count() const { return graph_.face_count(); }
  /// Indices of the shapes over the region, ascending.
  [[nodiscard]] std::span<const int> covering(int region) const {
    const auto begin = static_cast<std::size_t>(first_cover_[static_cast<std::size_t>(region)]);
    const auto end = static_cast<std::size_t>(first_cover_[static_cast<std::size_t>(region) + 1]);
    return {covers_.data() + begin, end - begin};
  }
  /// Zero for the unbounded region.
  [[nodiscard]] double area_mm2(int region) const { return graph_.area_mm2(region); }
  /// Appends the stretches of the region's border, a neighbour perhaps in several.
  void add_borders(int region, std::vector<Border>& stretches) const;

  /// The regions of each group as polygons: outer rings counter-clockwise, holes clockwise, no
  /// ring meets itself even in a vertex, and vertices on a straight line are left out; largest
  /// polygon first.
  /// @param group_of_region 0 to `groups` - 1, or -1 for what is left out. The unbounded region
  ///   always is.
  [[nodiscard]] std::vector<std::vector<Polygon>> trace(const std::vector<int>& group_of_region,
                                                        int groups) const;

 private:
  void find_coverings(int shape_count, int first_positive);

  std::vector<int> shape_of_ring_;  ///< ascending; the first ring of a shape is its outside
  PlaneGraph graph_;
  std::vector<int> first_cover_;
  std::vector<int> covers_;
};

/// The boundaries of groups of faces as polygons; see `PlanarMap::trace`.
[[nodiscard]] std::vector<std::vector<Polygon>> trace_boundaries(
    const PlaneGraph& graph, const std::vector<int>& group_of_face, int groups);

}  // namespace roomatlas::planar
