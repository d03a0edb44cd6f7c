// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/asr/store.hpp"
#include "roomatlas/core/geometry.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace roomatlas {

struct EvidenceOptions {
  int sweeps_per_asr = 40;     ///< sampled evenly; more costs time and hardly changes a figure
  int beams_per_sweep = 60;    ///< the same within a sweep
  double laser_range_m = 8.0;  ///< readings beyond it are free space up to it
  double sonar_range_m = 3.0;  ///< the same; a sonar's far hits lie anywhere on a wide arc
  double no_echo_m = 1.0;      ///< how much a reading without echo frees
  double cell_m = 0.1;         ///< of the free space that an ASR saw
  double step_m = 0.1;         ///< between samples along outlines, and of the lattice of areas
};

/// A ray that a sensor measured, in the ASR's frame.
struct MeasuredRay {
  Segment2 segment;     ///< from the sensor to where it ends
  bool is_hit = false;  ///< it ends at an obstacle
};

/// A point of a surface and the direction out of the room, behind the wall.
struct SurfaceSample {
  Point2 point = Point2::Zero();
  Point2 outwards = Point2::UnitX();
};

/// A place where something was hit: the mean of the hits in a cell, and across the surface.
struct HitCell {
  Point2 mean = Point2::Zero();
  Point2 seen_along = Point2::Zero();  ///< sum of the unit directions of the rays that hit it
  std::optional<Point2> normal;        ///< where the neighbourhood is straight; either sign
  int hits = 0;
};

/// What was hit near a point.
struct NearHit {
  bool is_near = false;            ///< something was hit within reach
  std::optional<double> across_m;  ///< distance to the nearest straight surface that was seen from
                                   ///< the same side, across it
};

/// Free space and hits on cells, in the ASR's frame.
class SeenSpace {
 public:
  SeenSpace() = default;
  SeenSpace(const std::vector<MeasuredRay>& rays, double cell_m);

  [[nodiscard]] const Box2& box() const { return box_; }
  /// How many sampled rays passed here without ending within two cells.
  [[nodiscard]] int free_rays(const Point2& point) const;
  /// @param along direction of the ray that ends at the point: a wall has two faces, and those
  ///   seen from the other side are other surfaces
  /// @param reach_m at most four cells
  [[nodiscard]] NearHit nearest_hit(const Point2& point, const Point2& along, double reach_m) const;

 private:
  struct CellIndex {
    int column = 0;
    int row = 0;
  };
  [[nodiscard]] CellIndex cell_of(const Point2& point) const;
  [[nodiscard]] std::optional<std::size_t> slot(const CellIndex& cell) const;
  void add_hits(const std::vector<MeasuredRay>& rays);
  void add_free(const std::vector<MeasuredRay>& rays);
  void mark_near_hits();
  void find_normals();
  /// Calls `visit` with each hit cell within `reach` cells (a square).
  template <typename Visit>
  void for_hits_near(const Point2& point, int reach, Visit visit) const;

  double cell_m_ = 0.1;  ///< as `EvidenceOptions` has it
  Box2 box_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::uint8_t> free_;       ///< saturates at 255
  std::vector<std::int32_t> hit_index_;  ///< into hits_, or -1
  std::vector<bool> near_hit_;           ///< cells within four cells of a hit
  std::vector<HitCell> hits_;
};

/// What one ASR's readings and geometry say, in its own frame: nothing of it depends on where the
/// ASR is placed.
struct AsrEvidence {
  AsrId asr = 0;
  bool has_readings = false;
  std::vector<MeasuredRay> rays;  ///< sampled
  SeenSpace seen;
  std::vector<Segment2> walls;          ///< wall edges that a line fit supports
  std::vector<SurfaceSample> surfaces;  ///< of the outline, where it runs along a wall
  Polygon outline;                      ///< of its free space
  std::vector<Exit> exits;
  std::optional<double> wall_direction_rad;  ///< of the walls, modulo a right angle; nothing where
                                             ///< they follow no one direction
};

/// Gathers the evidence of one ASR. Cost is bounded by the options, whatever the visit's length.
/// @param asr with readings, where they were kept; without them the figures on rays are not
/// measured
[[nodiscard]] AsrEvidence evidence_of(const Asr& asr, const EvidenceOptions& options);

/// The evidence of all ASRs, in the order of their ids.
/// @param jobs threads at once, see `for_each_index`; so many ASRs' readings are loaded at a time
[[nodiscard]] std::vector<AsrEvidence> evidence_of(const AsrSource& source,
                                                   const EvidenceOptions& options, int jobs = 1);

}  // namespace roomatlas
