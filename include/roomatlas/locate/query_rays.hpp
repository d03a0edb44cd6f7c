// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/asr/asr.hpp"

namespace roomatlas {

/// One measured range, to be asked whether it could have been measured elsewhere.
struct QueryRay {
  Pose2 query_from_beam;
  double range_m = 0.0;        ///< to the echo; without one as far as the sensor reaches
  double half_cone_rad = 0.0;  ///< [0, pi/2); 0: a laser's
  bool is_echo = true;
};

struct QueryRayOptions {
  double every_m = 0.25;                  ///< of the robot's way, between readings
  double laser_every_rad = radians(6.0);  ///< between beams of a laser
};

/// Some of the readings of a visit, spread over its path and around the robot, in the ASR's frame.
/// @param asr with readings and path
[[nodiscard]] std::vector<QueryRay> rays_of(const Asr& asr, const QueryRayOptions& options);

}  // namespace roomatlas
