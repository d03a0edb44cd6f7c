// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/mission/mission.hpp"
#include "roomatlas/plan/door.hpp"
#include "roomatlas/plan/ids.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace roomatlas {

enum class PassageKind {
  doorway,       ///< a narrow opening with two jambs: it separates rooms
  open_passage,  ///< a cut inside one room, made before the piece stops being rigid
};

/// Where the robot entered or left an ASR (paper section III: "exit and entry locations are
/// stored for later use as pivot points").
/// In the ASR's frame; the way leads out of it. An open passage has no width.
struct Exit : Doorway {
  PassageKind kind = PassageKind::doorway;
  bool is_entry = false;          ///< the robot came in here; else it left here
  std::optional<AsrId> neighbor;  ///< the ASR on the other side, where the robot was there
  double timestamp_s = 0.0;
};

/// A wall as a polyline whose edges know whether a line fit supports them.
struct WallPolyline {
  Polyline vertices_asr;
  std::vector<bool> edge_is_fitted;  ///< one an edge; false: the Douglas-Peucker edge was kept
};

struct PathSample {
  double timestamp_s = 0.0;
  Pose2 asr_from_robot;
  Pose2 odom_from_robot;  ///< as in the log
};

/// Sizes before and after (paper Fig. 2 and 9).
struct AsrCounters {
  std::int64_t grid_cells = 0;      ///< cells of the HIMM's bounding box
  std::int64_t grid_bytes = 0;      ///< one byte a cell
  std::int64_t occupied_cells = 0;  ///< over epsilon, before cleaning
  std::int64_t cleaned_cells = 0;   ///< after cleaning
  std::int64_t extracted_points = 0;
  std::int64_t vertices = 0;        ///< of walls
  std::int64_t geometry_bytes = 0;  ///< vertices x 2 x 4 (millimetres as 32-bit integers)
  std::int64_t ignored_ranges = 0;  ///< NaN, infinite or not positive
};

/// Absolute space representation (paper section II.B.1): what one visit to one space left
/// behind, in a frame of its own.
///
/// Frame: the origin is the entry pivot and x points along the direction of entry, so that the
/// paper's correction, a rotation about the entry pivot, is a change of the frame's heading and
/// of nothing else. The first ASR's origin is the robot's first pose.
/// Reference point (paper III.A step 5): the point of the outline farthest from its boundary,
/// because unlike a centroid it always lies inside, where a label or a robot can stand.
struct Asr {
  AsrId id = 0;
  RoomId room = 0;
  double start_s = 0.0;
  double end_s = 0.0;
  Pose2 odom_from_asr;  ///< where odometry put the frame: the uncorrected placement
  std::vector<WallPolyline> walls;
  Polygon outline_asr;      ///< free space, cut at the door lines; may be empty
  std::vector<Exit> exits;  ///< the entry first (none for the first ASR)
  Point2 reference_point_asr = Point2::Zero();
  bool is_localized = false;     ///< the path was found in the room's map; else it is odometry's
  std::vector<PathSample> path;  ///< one a reading
  std::vector<RangeReading> readings;  ///< parallel to `path`, or empty when not kept
  AsrCounters counters;
};

/// Length of the path inside the ASR, in metres; 0 when the path was not loaded.
[[nodiscard]] double path_length_m(const Asr& asr);

/// How much the robot turned along the path inside an ASR.
struct Turning {
  double absolute_rad = 0.0;  ///< left and right add up
  double signed_rad = 0.0;    ///< left less right
};
[[nodiscard]] Turning turning(const Asr& asr);

}  // namespace roomatlas
