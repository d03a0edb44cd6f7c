// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "roomatlas/grid/tile_grid.hpp"
#include "roomatlas/locate/floor_sketch.hpp"
#include "roomatlas/match/local_map.hpp"

namespace roomatlas {

/// What is known of a building: its walls with the side they were seen from, and its floor.
class SeenBuilding {
 public:
  /// Takes in what a mission saw, in the building's frame.
  void add(const FloorSketch& sketch);

  /// Floor and walls that are known.
  [[nodiscard]] double known_m2() const;
  [[nodiscard]] bool is_floor(const Point2& at) const;
  /// Whether the middle of floor that somebody saw stands on a wall.
  [[nodiscard]] bool has_wall_in(const Point2& floor) const;
  /// How far a wall lies off the nearest one that looks its way; nothing beyond `reach_m`.
  [[nodiscard]] std::optional<double> distance_to_wall(const Point2& at, const Point2& normal,
                                                       double reach_m) const;

  /// What a ray meets first.
  struct Met {
    double range_m = 0.0;
    double facing = 0.0;   ///< cosine of the angle of incidence; 0 where it is not known
    bool is_wall = false;  ///< else the ray ends there, or what is known does
  };
  [[nodiscard]] Met cast(const Pose2& building_from_beam, double reach_m) const;
  /// The same of straight stretches of wall alone, a metre and longer: what stands about in rooms,
  /// and people, are no part of any.
  [[nodiscard]] Met cast_to_stretch(const Pose2& building_from_beam, double reach_m) const;

  [[nodiscard]] const LocalMap& faces() const { return faces_; }
  [[nodiscard]] const TileGrid<char>& known_walls() const { return walls_; }
  [[nodiscard]] const TileGrid<char>& known_floor() const { return floor_; }

 private:
  template <typename Stops>
  [[nodiscard]] Met cast_until(const Pose2& building_from_beam, double reach_m, Stops stops) const;
  [[nodiscard]] bool is_on_stretch(const Face& face) const;
  [[nodiscard]] bool goes_on_at(const Face& face, double along_m) const;

  /// Marks a cell, and counts it where nothing was known of it.
  void note(TileGrid<char>& seen, const TileGrid<char>& other, const Cell& cell);

  LocalMap faces_{0.1};
  TileGrid<char> walls_;  ///< in cells of `kFloorCellM`: 1 where a sketch has a wall ...
  TileGrid<char> floor_;  ///< ... and where floor
  std::int64_t known_cells_ = 0;
};

}  // namespace roomatlas
