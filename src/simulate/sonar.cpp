// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar.hpp"

#include "obstacles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomatlas {
namespace {

constexpr int kRaysPerCone = 9;  // odd: one along the axis. 2.5 degrees apart in a 20 degree cone
constexpr double kLeastRange_m = 0.001;  // readings that are not positive mean "no measurement"

/// The smallest float that is not under `range_m`, so that a reading "at or beyond" the maximum
/// still is when compared in double precision.
float rounded_up(double range_m) {
  const auto rounded = static_cast<float>(range_m);
  if (static_cast<double>(rounded) >= range_m) return rounded;
  return std::nextafter(rounded, std::numeric_limits<float>::infinity());
}

}  // namespace

std::optional<double> cone_echo_m(const std::vector<Segment2>& edges, const Pose2& world_from_beam,
                                  const RangeSensor& sensor, double specular_limit_rad) {
  std::optional<double> nearest_m;
  for (int ray = 0; ray < kRaysPerCone; ++ray) {
    const double across = 2.0 * ray / (kRaysPerCone - 1) - 1.0;  // -1 to 1
    const double bearing_rad = world_from_beam.theta_rad + across * sensor.half_cone_rad;
    const auto hit =
        cast_ray(edges, world_from_beam.position(), direction(bearing_rad), sensor.max_range_m);
    if (!hit || hit->incidence_rad > specular_limit_rad) continue;
    if (!nearest_m || hit->range_m < *nearest_m) nearest_m = hit->range_m;
  }
  return nearest_m;
}

SonarReader::SonarReader(const SonarErrors& errors, std::uint64_t seed)
    : errors_(errors), range_noise_(seed, "sonar range"), dropout_(seed, "sonar dropout") {}

std::vector<float> SonarReader::read(const std::vector<Segment2>& edges,
                                     const Pose2& world_from_robot, const RangeSensor& ring) {
  std::vector<float> ranges_m;
  for (const Pose2& robot_from_beam : ring.robot_from_beam) {
    // Always one draw of each a beam: what one beam sees does not change another's noise.
    const double noise_m = errors_.range_noise_m * range_noise_.normal();
    const bool lost = dropout_.uniform() < errors_.dropout_share;
    const auto echo_m = cone_echo_m(edges, world_from_robot * robot_from_beam, ring,
                                    radians(errors_.specular_limit_deg));
    const double range_m = echo_m && !lost ? *echo_m + noise_m : ring.max_range_m;
    ranges_m.push_back(range_m < ring.max_range_m
                           ? static_cast<float>(std::max(range_m, kLeastRange_m))
                           : rounded_up(ring.max_range_m));
  }
  return ranges_m;
}

}  // namespace roomatlas
