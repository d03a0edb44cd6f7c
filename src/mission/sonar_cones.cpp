// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_cones.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "roomatlas/core/mixed_bits.hpp"

namespace roomatlas {
namespace {

// Where a Pioneer 2 has its sonars, front and rear, and how wide they hear.
constexpr double kHalfConeRad = radians(10.0);
constexpr std::array kFrontDeg = {90.0, 50.0, 30.0, 10.0, -10.0, -30.0, -50.0, -90.0};  // clockwise
constexpr std::array kRearDeg = {-90.0, -130.0, -150.0, -170.0, 170.0, 150.0, 130.0, 90.0};  // too
constexpr double kLeastRangeM = 0.1;  // nearer: the robot itself, or dust
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<std::size_t> beams_within(const RangeSensor& laser, double bearing_rad,
                                      double half_rad) {
  std::vector<std::size_t> beams;
  for (std::size_t i = 0; i < laser.robot_from_beam.size(); ++i) {
    const double off = wrap_angle(laser.robot_from_beam[i].theta_rad - bearing_rad);
    if (std::abs(off) <= half_rad) beams.push_back(i);
  }
  return beams;
}

/// A cone that no beam lies in hears nothing: it is none.
void add_cone(SonarCones& cones, RangeSensor& ring, double bearing_rad) {
  std::vector<std::size_t> beams = beams_within(*cones.laser, bearing_rad, kHalfConeRad);
  if (beams.empty()) return;
  cones.beams.push_back(std::move(beams));
  Pose2 beam = cones.laser->robot_from_beam[cones.beams.back().front()];
  beam.theta_rad = wrap_angle(bearing_rad);
  ring.robot_from_beam.push_back(beam);
}

bool is_echo(const SonarCones& cones, double range_m) {
  return range_m > kLeastRangeM && range_m < cones.laser->max_range_m;  // a NaN is none
}

/// Whether the surface that a beam meets throws the echo back: it is met within the limit, or is
/// an edge, which does so at any angle.
bool throws_back(const SonarCones& cones, const std::vector<float>& ranges_m, std::size_t beam,
                 double limit_rad) {
  constexpr double kBaseRad = radians(2.0);  // to either side, over which a surface is flat
  constexpr double kEdgeM = 0.3;  // a step in range that is an edge, not a surface at a flat angle
  const auto& poses = cones.laser->robot_from_beam;
  const auto neighbour = [&](int step) {
    std::size_t at = beam;
    while ((step > 0 ? at + 1 < poses.size() : at > 0) &&
           std::abs(wrap_angle(poses[at].theta_rad - poses[beam].theta_rad)) < kBaseRad - 1e-3) {
      at = step > 0 ? at + 1 : at - 1;
    }
    return at;
  };
  const std::size_t right = neighbour(-1);
  const std::size_t left = neighbour(1);
  const double range_m = ranges_m[beam];
  for (const std::size_t side : {right, left}) {
    if (!(std::abs(static_cast<double>(ranges_m[side]) - range_m) <= kEdgeM)) return true;
  }
  const Point2 along =
      poses[left] * Point2(ranges_m[left], 0.0) - poses[right] * Point2(ranges_m[right], 0.0);
  const Point2 ray = direction(poses[beam].theta_rad);
  const double incidence =
      std::atan2(std::abs(along.dot(ray)), std::abs(along.x() * ray.y() - along.y() * ray.x()));
  return incidence <= limit_rad;
}

/// A number in [0, 1) that the arguments decide.
double dice(std::uint64_t seed, std::uint64_t number, std::uint64_t cone, std::uint64_t purpose) {
  const std::uint64_t bits =
      finalised_bits(seed * 0x9E3779B97F4A7C15ULL + number * 0xD1B54A32D192ED03ULL +
                     cone * 0x8CB92BA72F3D8DD7ULL + purpose * 0xDB4F0B9175AE2165ULL);
  return static_cast<double>(bits >> 11) * 0x1.0p-53;
}

double noise(std::uint64_t seed, std::uint64_t number, std::uint64_t cone) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - dice(seed, number, cone, 1)));
  return radius * std::cos(2.0 * kPi * dice(seed, number, cone, 2));
}

}  // namespace

SonarCones sonar_cones(std::shared_ptr<const RangeSensor> laser, double max_range_m) {
  SonarCones cones{std::move(laser), nullptr, {}};
  RangeSensor ring;
  ring.kind = SensorKind::sonar;
  ring.half_cone_rad = kHalfConeRad;
  ring.max_range_m = static_cast<double>(static_cast<float>(max_range_m));
  constexpr double kNearBeamRad = radians(1.5);  // 180 beams of a front laser end at 89 degrees
  for (const double bearing_deg : kFrontDeg) {
    const double bearing_rad = radians(bearing_deg);
    if (beams_within(*cones.laser, bearing_rad, kNearBeamRad).empty()) continue;
    add_cone(cones, ring, bearing_rad);
  }
  for (const double bearing_deg : kRearDeg) {
    const auto sees = [&](double off_rad) {
      const double at_rad = radians(bearing_deg) + off_rad;
      return !beams_within(*cones.laser, at_rad, kNearBeamRad).empty();
    };
    if (sees(-kHalfConeRad) && sees(kHalfConeRad)) add_cone(cones, ring, radians(bearing_deg));
  }
  cones.ring = std::make_shared<const RangeSensor>(std::move(ring));
  return cones;
}

std::vector<float> heard(const SonarCones& cones, const std::vector<float>& laser_ranges_m,
                         const AsSonarOptions& options, std::uint64_t number) {
  std::vector<float> ranges_m;
  const bool all_throw_back = options.specular_limit_deg >= 90.0;
  for (std::size_t cone = 0; cone < cones.beams.size(); ++cone) {
    double least_m = kInfinity;
    bool measured = false;
    for (const std::size_t beam : cones.beams[cone]) {
      const double range_m = laser_ranges_m[beam];
      measured = measured || range_m > kLeastRangeM;
      if (!is_echo(cones, range_m) || range_m >= least_m) continue;
      if (all_throw_back ||
          throws_back(cones, laser_ranges_m, beam, radians(options.specular_limit_deg))) {
        least_m = range_m;
      }
    }
    if (!measured || dice(options.seed, number, cone, 0) < options.dropout_share) {
      ranges_m.push_back(0.0F);
    } else if (least_m >= cones.ring->max_range_m) {
      ranges_m.push_back(static_cast<float>(cones.ring->max_range_m));
    } else {
      if (options.range_noise_m > 0.0) {
        least_m += options.range_noise_m * noise(options.seed, number, cone);
      }
      ranges_m.push_back(static_cast<float>(std::max(least_m, kLeastRangeM)));
    }
  }
  return ranges_m;
}

}  // namespace roomatlas
