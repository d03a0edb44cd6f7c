// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "roomatlas/asr/recorder.hpp"
#include "roomatlas/odometry/late_odometry.hpp"

namespace roomatlas {

/// The online stage at the moment when it entered a room: all that the rooms from there on hang on,
/// besides the mission and the options. What hangs on the mission alone (directions of drives,
/// counts of readings and of what is wrong with them) is found again by reading it.
struct MapCheckpoint {
  std::int64_t events = 0;         ///< of the mission that had been taken by then
  std::int64_t readings = 0;       ///< of these, that had been given to the recorder
  std::int64_t true_poses = 0;     ///< that the sink holds
  std::int64_t wall_vertices = 0;  ///< of the ASRs that the sink holds
  LateOdometry::State odometry;
  RoomEntered room;  ///< all ASRs before it are in the sink
};

/// Bit by bit, so that a run goes on as it would have.
[[nodiscard]] std::string to_bytes(const MapCheckpoint& checkpoint);
/// @throws InputError for bytes of another version, and for what no run can have left
[[nodiscard]] MapCheckpoint map_checkpoint_of(const std::string& bytes);

}  // namespace roomatlas
