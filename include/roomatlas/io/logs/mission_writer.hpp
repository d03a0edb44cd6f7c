// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "roomatlas/io/files/path.hpp"
#include "roomatlas/mission/mission.hpp"
#include "roomatlas/simulate/simulate.hpp"

namespace roomatlas {

/// Writes a mission, whatever the format, event by event. The same calls give the same bytes.
/// Every failure of the disk throws InputError; a reading whose ranges are not as many as its
/// sensor's beams std::invalid_argument.
class MissionWriter {
 public:
  virtual ~MissionWriter() = default;
  /// What odometry says; before the readings of that time, which have their pose from it. Without
  /// any the mission is one without odometry.
  virtual void write(const OdometryStep& odometry) = 0;
  /// A laser whose beams are not evenly spaced is written as one that has them so.
  virtual void write(const RangeReading& reading) = 0;
  virtual void write(const TruePose& truth) = 0;
  /// Gives the file its final name. Without it nothing is left behind.
  virtual void finish() = 0;

  /// Odometry, reading and truth of a step, in this order.
  void write(const SimulatedStep& step) {
    write(step.odometry);
    write(step.reading);
    write(step.truth);
  }
};

/// By the name's end: ".clf" or ".log" is a CARMEN log; ".bag" a ROS 1 bag, ".mcap", ".db3", and a
/// folder's name a rosbag2. Throws InputError for another, and where nothing can be written.
/// @param sensor the first that will be written: a CARMEN log tells its range beforehand
/// @param footprint a CARMEN log holds it; recordings of topics have no place for it
[[nodiscard]] std::unique_ptr<MissionWriter> create_mission(const Path& file,
                                                            const RangeSensor& sensor,
                                                            const RobotFootprint& footprint);

/// Whether such a file is a recording of topics.
[[nodiscard]] bool is_recording_name(const Path& file);

}  // namespace roomatlas
