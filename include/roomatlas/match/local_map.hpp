// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "roomatlas/grid/tile_grid.hpp"
#include "roomatlas/match/scan.hpp"

namespace roomatlas {

/// One side of a surface inside one cell: the mean of the hits there.
struct Face {
  Point2 position = Point2::Zero();
  Point2 normal = Point2::Zero();  ///< unit; zero where the hits disagree or none has one
  double hits = 0.0;
};

/// What a room looks like to a scan matcher: HIMM certainty for a coarse search, and in each cell
/// that was hit the mean position and direction of the surface, apart for the two faces of a wall.
/// Positions are finer than the cells, so that alignment is not bound to the raster.
class LocalMap {
 public:
  explicit LocalMap(double cell_m) : frame_{cell_m} {}

  void add(const Scan& scan, const Pose2& map_from_robot);
  /// Takes what another map saw of a surface, as so many hits; says nothing of free space.
  void add(const Face& seen);

  /// HIMM's certainty in half steps, [-6, 30]; 0 where nothing is known.
  [[nodiscard]] int certainty(const Cell& cell) const { return cells_.at(cell).certainty; }
  [[nodiscard]] bool is_seen_free(const Cell& cell) const { return certainty(cell) <= kSeenFree; }

  /// Visits all faces within `radius_m` of a point, and some farther ones.
  template <typename Visit>
  void for_each_face_near(const Point2& at, double radius_m, Visit visit) const {
    const Cell low = frame_.cell_of({at.x() - radius_m, at.y() - radius_m});
    const Cell high = frame_.cell_of({at.x() + radius_m, at.y() + radius_m});
    cells_.for_each_in({low, {high.x + 1, high.y + 1}}, [&](const LocalCell& cell) {
      for (std::uint32_t i = cell.face; i != 0; i = faces_[i - 1U].other) {
        visit(faces_[i - 1U].mean);
      }
    });
  }

  /// All faces with at least this many hits, cell by cell.
  [[nodiscard]] std::vector<Face> faces(double min_hits) const;
  /// Visits each cell that was seen free, then each that holds a face of at least `min_hits`.
  template <typename VisitFree, typename VisitFace>
  void for_each_known_cell(double min_hits, VisitFree free, VisitFace face) const {
    cells_.for_each([&](const Cell& cell, const LocalCell& value) {
      if (value.certainty <= kSeenFree) free(cell);
    });
    cells_.for_each([&](const Cell& cell, const LocalCell& value) {
      for (std::uint32_t i = value.face; i != 0; i = faces_[i - 1U].other) {
        if (faces_[i - 1U].mean.hits < min_hits) continue;
        face(cell);
        break;
      }
    });
  }

  [[nodiscard]] bool empty() const { return faces_.empty(); }
  [[nodiscard]] const CellFrame& frame() const { return frame_; }
  [[nodiscard]] CellBox box() const { return cells_.box(); }

 private:
  static constexpr int kSeenFree = -2;  ///< half steps: C of -1, one ray more than hits make up for

  struct LocalCell {
    std::int8_t certainty = 0;
    std::uint32_t face = 0;  ///< index into `faces_` plus one; 0: none
  };
  struct StoredFace {
    Face mean;
    Point2 normal_sum = Point2::Zero();
    std::uint32_t other = 0;  ///< the cell's second face
  };

  void add_free(const Point2& from, const Point2& to);
  void raise(const Cell& cell, int half_steps);
  void add_hit(const Point2& position, const Point2& normal);

  CellFrame frame_;
  TileGrid<LocalCell> cells_;
  std::vector<StoredFace> faces_;
};

}  // namespace roomatlas
