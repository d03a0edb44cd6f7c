// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/mission/mission.hpp"

#include <optional>
#include <vector>

namespace roomatlas::io {

/// A laser's beams as formats of logs have them: from one point, evenly spaced.
struct BeamFan {
  Point2 origin = Point2::Zero();  ///< in the robot's frame
  double first_rad = 0.0;          ///< the first beam's direction in the robot's frame
  double step_rad = 0.0;           ///< to the next; negative: clockwise
};

/// Nothing where the beams start at several points or are not evenly spaced.
[[nodiscard]] std::optional<BeamFan> fan_of(const RangeSensor& laser);

/// The same sweep by beams that are a fan, from the first one's origin; as it is where they are
/// already.
/// @param reading of a laser
[[nodiscard]] RangeReading as_fan(const RangeReading& reading);

/// The reading of each laser of one that has several, by beams that are a fan.
[[nodiscard]] std::vector<RangeReading> fans_in(const RangeReading& reading);

/// Throws std::invalid_argument where a reading's ranges are not as many as its sensor's beams.
void require_a_range_a_beam(const RangeReading& reading);

}  // namespace roomatlas::io
