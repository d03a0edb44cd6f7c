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

  /// Neighbouring points of a row of a square lattice, all in one cell.
  struct Run {
    Point2 first = Point2::Zero();
    double step_m = 0.0;
    std::int64_t count = 0;
    [[nodiscard]] Point2 at(std::int64_t i) const {
      return {first.x() + static_cast<double>(i) * step_m, first.y()};
    }
  };

  /// Visits the cells along rows of points: `visit(cell, run)` for all points of a square lattice
  /// inside the box of all lines, but for those in the unbounded cell. Runs may be long: most of
  /// the box around a building may be far from it.
  template <typename Visit>
  void for_each_run(double step_m, Visit visit) const {
    const Rows rows = rows_of(step_m);
    for (int row = 0; row < rows.count; ++row) {
      const double y_m = rows.from.y() + (row + 0.5) * step_m;
      const std::vector<Crossing> crossings = crossings_at(rows, row);
      for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        if (crossings[i].cell_after == 0) continue;
        const auto column_at = [&](double x_m) {
          return static_cast<std::int64_t>(std::ceil((x_m - rows.from.x()) / step_m - 0.5));
        };
        const std::int64_t first = column_at(crossings[i].x_m);
        const std::int64_t count = column_at(crossings[i + 1].x_m) - first;
        if (count <= 0) continue;
        const double x_m = rows.from.x() + (static_cast<double>(first) + 0.5) * step_m;
        visit(crossings[i].cell_after, Run{{x_m, y_m}, step_m, count});
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
