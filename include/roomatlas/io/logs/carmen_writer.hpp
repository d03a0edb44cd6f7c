// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "roomatlas/io/files/path.hpp"
#include "roomatlas/mission/mission.hpp"
#include "roomatlas/simulate/simulate.hpp"

namespace roomatlas {

/// Writes a CARMEN log with PARAM, ODOM, SONAR or FLASER, and TRUEPOS lines, step by step. A laser
/// must have 181 beams from -90 to 90 degrees, since FLASER lines carry no bearings
/// (std::invalid_argument).
class CarmenWriter {
 public:
  CarmenWriter(const Path& file, const RangeSensor& sensor, const RobotFootprint& footprint);
  ~CarmenWriter();
  CarmenWriter(const CarmenWriter&) = delete;
  CarmenWriter& operator=(const CarmenWriter&) = delete;
  void write(const SimulatedStep& step);
  /// Renames the temporary file to its final name. Without it nothing is left behind.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace roomatlas
