// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "roomatlas/io/logs/mission_writer.hpp"

namespace roomatlas {

/// Writes a CARMEN log with PARAM, ODOM, SONAR or laser, and TRUEPOS lines. A laser with 181 beams
/// from -90 to 90 degrees gets FLASER lines, which carry no bearings; another ROBOTLASER1 lines.
class CarmenWriter : public MissionWriter {
 public:
  /// @param sensor the first that will be written
  CarmenWriter(const Path& file, const RangeSensor& sensor, const RobotFootprint& footprint);
  ~CarmenWriter() override;
  CarmenWriter(const CarmenWriter&) = delete;
  CarmenWriter& operator=(const CarmenWriter&) = delete;
  using MissionWriter::write;
  void write(const OdometryStep& odometry) override;
  void write(const RangeReading& reading) override;
  void write(const TruePose& truth) override;
  void finish() override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace roomatlas
