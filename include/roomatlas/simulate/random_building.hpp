// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/asr/store.hpp"
#include "roomatlas/plan/floor_plan.hpp"
#include "roomatlas/simulate/simulate.hpp"

#include <cstdint>
#include <functional>

namespace roomatlas {

/// A building of any size, for measuring the offline stage without driving through it.
struct RandomBuildingOptions {
  std::int64_t rooms = 100;  ///< corridors count as rooms; at least 1
  std::uint64_t seed = 1;    ///< decides building, drive and errors
  OdometryErrors odometry;
  double vertex_noise_m = 0.03;   ///< standard deviation of each vertex of a wall or outline, per
                                  ///< axis; half a cell is 0.05
  double jamb_noise_m = 0.04;     ///< the same for the jambs of a doorway that was driven through
  double sample_every_m = 1.0;    ///< of path; smaller makes ASRs larger, not better
  double max_piece_path_m = 8.0;  ///< longer visits are cut at an open passage, as by the recorder
  double speed_m_per_s = 0.4;     ///< tells the times of poses alone
  double start_timestamp_s = 1000000000.0;  ///< since 1970, of the first pose
};

/// Where an ASR truly is.
struct TrueVisit {
  AsrId asr = 0;
  RoomId room = 0;  ///< of the true plan
  Pose2 world_from_asr;
};

struct RandomBuildingSummary {
  std::int64_t rooms = 0;
  std::int64_t doors = 0;
  std::int64_t asrs = 0;
  std::int64_t crossings = 0;  ///< of doorways; each door is crossed at least once
  std::int64_t path_samples = 0;
  std::int64_t vertices = 0;  ///< of walls
  double path_length_m = 0.0;
};

/// Drives through a random building and hands over what the recorder would have made of each
/// visit: ASRs in their own frames with outline, walls, exits, path and counters, but no readings.
/// The building: blocks of about twenty rooms (offices, laboratories, few halls) on both sides of a
/// corridor, blocks in rows; corridors joined end to end by doors, rows by link rooms; some rooms
/// joined to their neighbours. So there are loops of every size, and every room can be reached.
/// Odometry drifts over the path driven; inside an ASR the walls carry the drift of its middle.
/// Memory does not grow with the number of rooms.
/// @param sink gets the ASRs, ids 1, 2, 3 ... in order, and before each its true poses
/// @param truth called before each ASR is handed over; may be empty
/// @throws UsageError when there are no rooms, or a noise or length is negative or not finite
RandomBuildingSummary random_building(const RandomBuildingOptions& options, AsrSink& sink,
                                      const std::function<void(const TrueVisit&)>& truth = {});

/// The true plan of the same building, block by block; rooms and doors are numbered through.
/// Walls are rectangles that do not overlap. Memory does not grow with the number of rooms.
/// @param sink gets each part once; together they are the plan
void random_building_plan(const RandomBuildingOptions& options,
                          const std::function<void(const FloorPlan&)>& sink);

/// The same plan as a whole.
[[nodiscard]] FloorPlan random_building_plan(const RandomBuildingOptions& options);

}  // namespace roomatlas
