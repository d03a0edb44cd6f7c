// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "roomatlas/mission/mission.hpp"

namespace roomatlas {

/// A laser's beams as cones of a sonar ring.
struct SonarCones {
  std::shared_ptr<const RangeSensor> laser;
  std::shared_ptr<const RangeSensor> ring;
  std::vector<std::vector<std::size_t>> beams;  ///< of the laser, in each cone of the ring
};

[[nodiscard]] SonarCones sonar_cones(std::shared_ptr<const RangeSensor> laser, double max_range_m);

/// What the cones hear of one sweep.
/// @param number of the reading in its log; with the seed it decides noise and losses
[[nodiscard]] std::vector<float> heard(const SonarCones& cones,
                                       const std::vector<float>& laser_ranges_m,
                                       const AsSonarOptions& options, std::uint64_t number);

}  // namespace roomatlas
