// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/planar/millimetre_grid.hpp"
#include "roomatlas/planar/plane_graph.hpp"

namespace roomatlas {

/// A line on which walls may run, and what speaks for it.
struct DraftLine {
  Segment2 segment;           ///< building metres
  double prominence_m = 0.0;  ///< metres of wall seen on it; 0 for lines that are no walls'
  bool is_wall = false;       ///< false: a door's line, or the rim of what was seen
};

/// The plane cut into cells by lines. Cell 0 is unbounded.
class Arrangement {
 public:
  /// @param lines at least one
  explicit Arrangement(const std::vector<DraftLine>& lines);

  /// A stretch of border between two cells.
  struct Border {
    int left = 0;  ///< cell to the left of the way from a to b
    int right = 0;
    Segment2 segment;           ///< metres
    double prominence_m = 0.0;  ///< the largest of the lines that run along it
    bool is_wall = false;       ///< a wall's line runs along it
  };

  [[nodiscard]] int cell_count() const { return graph_.face_count(); }
  [[nodiscard]] double area_m2(int cell) const { return graph_.area_mm2(cell) * 1e-6; }
  [[nodiscard]] const std::vector<Border>& borders() const { return borders_; }
  /// The cells of each group as polygons, in metres; see `PlanarMap::trace`.
  [[nodiscard]] std::vector<std::vector<Polygon>> trace(const std::vector<int>& group_of_cell,
                                                        int groups) const;

  /// Visits the cells along rows of points: `visit(cell, point)` for each point of a square lattice
  /// inside the box of all lines, but for those in the unbounded cell.
  template <typename Visit>
  void for_each_point(double step_m, Visit visit) const {
    const Rows rows = rows_of(step_m);
    for (int row = 0; row < rows.count; ++row) {
      const double y_m = rows.from.y() + (row + 0.5) * step_m;
      const std::vector<Crossing> crossings = crossings_at(rows, row);
      for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        if (crossings[i].cell_after == 0) continue;
        auto column =
            static_cast<std::int64_t>(std::ceil((crossings[i].x_m - rows.from.x()) / step_m - 0.5));
        for (;; ++column) {
          const double x_m = rows.from.x() + (static_cast<double>(column) + 0.5) * step_m;
          if (x_m >= crossings[i + 1].x_m) break;
          visit(crossings[i].cell_after, Point2(x_m, y_m));
        }
      }
    }
  }

 private:
  struct Rows {
    Point2 from = Point2::Zero();
    double step_m = 0.0;
    int count = 0;
    std::vector<std::vector<int>> borders_of_row;  ///< those that cross its middle
  };
  struct Crossing {
    double x_m = 0.0;
    int cell_after = 0;
  };
  [[nodiscard]] Rows rows_of(double step_m) const;
  [[nodiscard]] std::vector<Crossing> crossings_at(const Rows& rows, int row) const;

  planar::MillimetreGrid grid_;
  planar::PlaneGraph graph_;
  std::vector<Border> borders_;
};

}  // namespace roomatlas
