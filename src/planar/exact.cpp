// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that includes CGAL: it costs seconds of compile time.
#include "predicates.hpp"
#include "roomatlas/planar/edges.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Snap_rounding_2.h>
#include <CGAL/Snap_rounding_traits_2.h>

#include <list>

namespace roomatlas::planar {

int exact_orientation(const Point2& a, const Point2& b, const Point2& c) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  return static_cast<int>(
      CGAL::orientation(Point(a.x(), a.y()), Point(b.x(), b.y()), Point(c.x(), c.y())));
}

EdgeSet cut_by_snap_rounding(const EdgeSet& set) {
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Traits = CGAL::Snap_rounding_traits_2<Kernel>;
  const double pixel_mm = 4.0 / set.fine;  // coarser than the grid on which rounds did not end
  std::list<Traits::Segment_2> segments;
  for (const RingEdge& edge : set.edges) {
    const Point2& a = set.point(edge.from);
    const Point2& b = set.point(edge.to);
    segments.emplace_back(Kernel::Point_2(a.x(), a.y()), Kernel::Point_2(b.x(), b.y()));
  }
  std::list<std::list<Traits::Point_2>> chains;
  CGAL::snap_rounding_2<Traits>(segments.begin(), segments.end(), chains, pixel_mm, true, false);
  EdgeSet cut{set.fine, {}, {}};
  PointNumbers numbers(cut.points_mm, set.points_mm.size());
  auto edge = set.edges.begin();
  for (const auto& chain : chains) {
    int from = -1;
    for (const auto& point : chain) {
      const int to = numbers.number_of(
          on_fine_grid({CGAL::to_double(point.x()), CGAL::to_double(point.y())}, set.fine));
      if (from >= 0 && from != to) cut.edges.push_back({from, to, edge->ring});
      from = to;
    }
    ++edge;
  }
  return cut;
}

}  // namespace roomatlas::planar
