// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "roomatlas/asr/doorway.hpp"
#include "roomatlas/asr/map_room.hpp"
#include "roomatlas/asr/store.hpp"
#include "roomatlas/match/room_localizer.hpp"

namespace roomatlas {

struct RecorderOptions {
  RoomMapOptions map;
  DoorwayOptions doorway;
  double doorway_lag_m = 0.6;      ///< how far behind the robot doorways are looked for; both
                                   ///< jambs must have been seen by then
  double min_doorway_gap_m = 1.0;  ///< two doorways on the path are at least this far apart
  double max_piece_path_m = 8.0;   ///< longer visits are cut at an open passage: odometry bends
                                   ///< longer pieces
  int max_piece_readings = 5000;   ///< the same for a robot that hardly moves; bounds memory
  bool keep_readings = true;       ///< store the readings, so that rooms can be mapped again
};

/// A room that the robot has just entered, and all else that the recorder remembers then: what the
/// rooms after it hang on.
struct RoomEntered {
  AsrId asr = 1;  ///< of the room
  Pose2 odom_from_asr;
  std::optional<Exit> entry;
  std::vector<Pose2> seed;  ///< where the robot was in the room's frame at the last readings before
                            ///< it, with which its live grid and the localizer's map begin ...
  std::vector<Pose2> path;  ///< ... and then at its own: it is noticed late that a room was left
  Pose2 reckoned_from_robot;              ///< at the last of them
  std::optional<double> since_doorway_m;  ///< path from the last doorway to the room's begin
  LearntOdometry learnt;
};

/// The online stage: a stream of readings becomes a stream of ASRs (paper III). The one object
/// that remembers: it holds the room being mapped and, for some readings, the one before, which a
/// thread of its own maps meanwhile; nothing of the rooms before, so that cost and memory do not
/// depend on how long the mission has been.
class AsrRecorder {
 public:
  /// @param localizer finds the robot inside a room; none: dead reckoning is believed
  AsrRecorder(const RecorderOptions& options, const RobotFootprint& footprint, AsrSink& sink,
              std::unique_ptr<Localizer> localizer = nullptr);
  ~AsrRecorder();
  AsrRecorder(const AsrRecorder&) = delete;
  AsrRecorder& operator=(const AsrRecorder&) = delete;

  /// Takes the next reading, in the mission's order. May hand one ASR to the sink.
  /// @param reckoned_from_robot the robot's pose by the best odometry there is, in a frame of its
  ///   own; the log's odometry where nothing better is known
  void add(const RangeReading& reading, const Pose2& reckoned_from_robot);
  /// Hands over the room being mapped. Call once, at the mission's end or interruption.
  void finish();

  /// The room that is being mapped, as it was entered; as it is by default before one was left.
  [[nodiscard]] const RoomEntered& entered() const;
  /// Before the first reading: goes on behind `readings` as the recorder did that entered this room
  /// with them.
  /// @param readings of the room's seed and path, in the mission's order
  void resume(const RoomEntered& room, const std::vector<RangeReading>& readings);

  /// True for some readings after a room was left: the next room's first sweeps are drawn beside
  /// them, and each costs more than most.
  [[nodiscard]] bool has_just_left() const;
  [[nodiscard]] std::int64_t asrs_written() const;
  /// Of odometry, as the localizer learnt them.
  [[nodiscard]] std::optional<OdometryHabits> habits() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace roomatlas
