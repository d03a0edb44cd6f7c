// SPDX-License-Identifier: GPL-3.0-or-later
// Stretches of wall in the map, and which of them a return may have come from.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "roomatlas/sonar/wall_segments.hpp"
#include "square_index.hpp"
#include "wall_pairs.hpp"

namespace roomatlas {

struct WallStretch {
  ConeLine line;
  Point2 middle = Point2::Zero();
  Point2 along = Point2::Zero();  ///< of unit length
  double half_length_m = 0.0;
};

/// The walls as a batch left them, by the squares that they pass through.
class WallStretches {
 public:
  WallStretches(std::span<const SeenWall> walls, std::span<const Pose2> map_from_node);

  /// Visits those about a place, by square: a long one more than once.
  /// @param visit takes the wall's number and the stretch
  template <typename Visit>
  void for_each_near(const Point2& at, Visit visit) const {
    const Square square = square_of(at, kTileM);
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (const std::uint32_t i : near_.at({square.x + dx, square.y + dy})) {
          visit(i, stretches_[i]);
        }
      }
    }
  }

 private:
  static constexpr double kTileM = 1.0;  // time alone

  [[nodiscard]] static std::vector<SquareIndex::Entry> squares_of(
      const std::vector<WallStretch>& stretches);

  std::vector<WallStretch> stretches_;
  SquareIndex near_;
};

/// Whether a single return says anything of walls: nearer a sonar hears its own ringing, farther
/// many things at once.
[[nodiscard]] bool tells_of_walls(double range_m, const RangeSensor& sensor);

/// The range at which a sonar would hear the stretch, by the model of a cone (`range_to_line`);
/// nothing where the return did not come from it.
[[nodiscard]] std::optional<double> range_to_stretch(const ConeReturn& heard, double half_cone_rad,
                                                     const WallStretch& wall);

}  // namespace roomatlas
