// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "obstacles.hpp"
#include "random_stream.hpp"
#include "roomatlas/core/geometry.hpp"
#include "roomatlas/mission/mission.hpp"
#include "roomatlas/simulate/simulate.hpp"
#include "silent_walls.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace roomatlas {

/// The range that one beam measures without noise: the nearest echo of rays spread over its cone.
/// A ray that meets a surface at more than `specular_limit_deg` from its normal is thrown away from
/// a sonar and has no echo. A convex corner in the cone, taken half as wide again,
/// sends a weak echo from every angle, heard up to `corner_echo_m` (Kuc and Siegel 1987). Nothing
/// where there is no echo.
[[nodiscard]] std::optional<double> echo_m(const Obstacles& obstacles, const Pose2& world_from_beam,
                                           const RangeSensor& sensor, const SonarErrors& errors);

/// The range that one beam of a laser measures without noise where walls may be black or glass.
[[nodiscard]] std::optional<double> echo_past_glass_m(const Obstacles& obstacles,
                                                      const Pose2& world_from_beam,
                                                      double max_range_m,
                                                      const SilentWalls& silent);

/// Reads a ring of sonars or a laser in the world. A lost reading, and one without an echo, is the
/// maximum range.
class RangeReader {
 public:
  explicit RangeReader(const SimulationOptions& options);
  /// @param obstacles all that come into the sensor's range
  /// @return metres, one a beam, in (0, max_range_m]
  [[nodiscard]] std::vector<float> read(const Obstacles& obstacles, const Pose2& world_from_robot,
                                        const RangeSensor& sensor);

 private:
  using Echoes = std::vector<std::optional<double>>;
  [[nodiscard]] Echoes with_crosstalk(const Echoes& echoes_m);

  SonarErrors sonar_;
  LaserErrors laser_;
  SilentWalls silent_;
  RandomStream range_noise_;
  RandomStream dropout_;
  RandomStream crosstalk_;
};

}  // namespace roomatlas
