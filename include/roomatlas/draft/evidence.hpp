// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/asr/store.hpp"
#include "roomatlas/core/progress.hpp"
#include "roomatlas/graph/room_graph.hpp"
#include "roomatlas/grid/reflection_map.hpp"
#include "roomatlas/mission/mission.hpp"

namespace roomatlas {

/// How readings are gathered for drafting.
struct GatherOptions {
  double cell_m = 0.05;         ///< of the counting grid; larger rounds the ends of walls
  double laser_every_m = 0.05;  ///< a sweep counts after this much motion ...
  double sonar_every_m = 0.03;  ///< ... of sonars, which have few beams ...
  double every_deg = 2.0;       ///< ... or turn; less costs time and tells nothing new
  double laser_range_m = 10.0;  ///< hits farther away smear walls by the heading's error
  double sonar_range_m = 4.0;   ///< a cone is 2 m wide there
  double coarse_cell_m = 0.1;  ///< of what sonars' rooms are decided on: finer leaves gaps in walls
  double coarse_range_m = 8.0;
  double sonar_no_echo_m = 1.0;  ///< what a sonar without echo frees. A laser without echo frees
                                 ///< nothing: beams are lost on furniture too
};

/// A small piece of surface that a laser saw; building metres.
struct SurfacePoint {
  Point2 at = Point2::Zero();
  double normal_rad = 0.0;  ///< towards the side from which it was seen
  double weight = 0.0;      ///< how many beams
};

/// What one sonar heard; building metres.
struct Echo {
  Pose2 building_from_beam;
  double range_m = 0.0;
  bool is_hit = false;  ///< false: nothing was heard up to the range
  double free_m = 0.0;  ///< how far it frees: up to the echo, unless that is too far away to count
};

/// Everything that a mission says about where walls are, in the building's frame.
struct BuildingEvidence {
  SensorKind kind = SensorKind::laser;  ///< sonar where there were both
  ReflectionMap counts{0.05};           ///< in cells of `GatherOptions::cell_m`
  std::vector<SurfacePoint> surfaces;   ///< seen by lasers; thinned to one a place and direction
  std::vector<Echo> echoes;             ///< of sonars
  ReflectionMap coarse{0.1};            ///< of sonars, in cells of `GatherOptions::coarse_cell_m`
  RobotFootprint footprint;             ///< where it stood is free
  double sonar_half_cone_rad = 0.0;
  std::vector<Pose2> building_from_robot;  ///< the whole path
  std::vector<AsrId> asr_of_pose;          ///< parallel to the path
};

/// Gathers all readings where the correction puts them. Readings are loaded for one ASR at a time,
/// and those of the next beside.
/// @param jobs threads at once, see `for_each_index`
/// @throws InputError for an ASR without its readings
[[nodiscard]] BuildingEvidence gather_evidence(const AsrSource& source, const Placement& placement,
                                               const RobotFootprint& footprint,
                                               const GatherOptions& options,
                                               const Progress& progress, int jobs = 1);

/// Adds what lasers saw at another time. What was heard is not added.
void add_seen(const BuildingEvidence& more, BuildingEvidence& evidence);

/// What one reading of sonars heard; beams without a range are left out.
[[nodiscard]] std::vector<Echo> echoes_of(const RangeReading& reading,
                                          const Pose2& building_from_robot,
                                          const GatherOptions& options);

/// The surfaces that one sweep of a laser saw: a normal for each beam whose neighbours lie on a
/// straight piece of up to 0.8 m, by principal components of as few of them as span 0.35 m.
/// @param reading of a laser whose beams are in the order of their angles
[[nodiscard]] std::vector<SurfacePoint> surfaces_of(const RangeReading& reading,
                                                    const Pose2& building_from_robot,
                                                    double max_range_m);

/// One point for all that lie in the same 2 cm x 2 cm and 10 degrees of normal, in a fixed order.
[[nodiscard]] std::vector<SurfacePoint> thinned(std::vector<SurfacePoint> points);

}  // namespace roomatlas
