// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/grid/cells.hpp"
#include "roomatlas/mission/mission.hpp"

namespace roomatlas {

/// One ray of a sweep in the grid's frame, from the sensor to where it ends.
struct Ray {
  Segment2 segment;
  bool ends_at_obstacle = false;  ///< false: free space was seen up to the end, nothing more
};

/// Histogram in-motion mapping (Borenstein and Koren 1991; paper II.A, with the changes of
/// III.B): a grid of certainty values C in [-3, 15], one byte a cell, counted in half steps. It
/// grows with what it sees.
///
/// Changes to the paper: a sweep lowers the cells along all its rays before it raises the cells
/// at its hits, and a ray stops short of the eight cells that its own hit raises. Without both,
/// a scanner with 180 beams wears away the walls that it sees at a flat angle.
class HimmGrid {
 public:
  static constexpr int kHitHalfSteps = 6;          ///< +3 at the hit
  static constexpr int kNeighborHalfSteps = 3;     ///< +1.5 at its eight neighbours
  static constexpr int kFreeHalfSteps = -2;        ///< -1 along the ray
  static constexpr int kMaxHalfSteps = 30;         ///< 15
  static constexpr int kMinHalfSteps = -6;         ///< -3
  static constexpr std::int8_t kRobotPath = -128;  ///< the robot stood here

  explicit HimmGrid(double cell_m) : frame_{cell_m} {}

  /// Applies one sweep: -1 along each ray, then +3 and +1.5 around each hit.
  void add_sweep(const std::vector<Ray>& rays);

  /// Marks the cells under the robot as robot path. They stay so whatever is seen later.
  void mark_robot(const Pose2& grid_from_robot, const RobotFootprint& footprint);

  /// The stored byte: half steps, or kRobotPath; 0 (unknown) outside of the box.
  [[nodiscard]] std::int8_t raw(const Cell& cell) const {
    return box_.contains(cell) ? cells_[box_.index_of(cell)] : std::int8_t{0};
  }
  /// The certainty value C in [-3, 15]; -3 for robot path, 0 outside.
  [[nodiscard]] double value(const Cell& cell) const;
  [[nodiscard]] bool is_robot_path(const Cell& cell) const { return raw(cell) == kRobotPath; }

  [[nodiscard]] const CellBox& box() const { return box_; }
  [[nodiscard]] const CellFrame& frame() const { return frame_; }

 private:
  void cover(const Cell& cell);
  void add(const Cell& cell, int half_steps);

  CellFrame frame_;
  CellBox box_;
  std::vector<std::int8_t> cells_;
};

/// How far readings are believed.
struct RayOptions {
  double max_mapped_range_m = 8.0;  ///< rays are cut there and then end in free space
  double sonar_no_echo_m = 1.0;     ///< how much a sonar without echo frees
  double laser_no_echo_m = 5.0;     ///< how much a laser without echo in the mapped range frees
};

/// The rays of a reading: one a beam that measured something.
/// @param grid_from_robot pose of the robot in the grid's frame
/// @param[out] ignored is raised by the number of beams without a measurement (NaN, infinite,
///   not positive)
[[nodiscard]] std::vector<Ray> rays_of(const RangeReading& reading, const Pose2& grid_from_robot,
                                       const RayOptions& options, std::int64_t& ignored);

}  // namespace roomatlas
