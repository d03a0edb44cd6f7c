// SPDX-License-Identifier: GPL-3.0-or-later
#include "range_reader.hpp"

#include "obstacles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomatlas {
namespace {

constexpr int kRaysPerCone = 9;  // odd: one along the axis. 2.5 degrees apart in a 20 degree cone
constexpr double kCornerCone = 1.5;  // near by, the lobe is wider; else the two front cones of a
                                     // Pioneer would leave a blind strip straight ahead
constexpr double kBehindCornerM = 1e-6;  // what hides a corner is nearer than it by more
constexpr double kBehindGlassM = 1e-6;   // where a ray goes on; less meets the same face again
constexpr double kLeastRange_m = 0.001;  // readings that are not positive mean "no measurement"

/// The smallest float that is not under `range_m`, so that a reading "at or beyond" the maximum
/// still is when compared in double precision.
float rounded_up(double range_m) {
  const auto rounded = static_cast<float>(range_m);
  if (static_cast<double>(rounded) >= range_m) return rounded;
  return std::nextafter(rounded, std::numeric_limits<float>::infinity());
}

}  // namespace

namespace {

std::optional<double> corner_echo_m(const Obstacles& obstacles, const Pose2& world_from_beam,
                                    double half_cone_rad, double reach_m) {
  std::optional<double> nearest_m;
  for (const Point2& corner : obstacles.corners) {
    const Point2 offset = corner - world_from_beam.position();
    const double range_m = offset.norm();
    const double off_axis_rad =
        wrap_angle(std::atan2(offset.y(), offset.x()) - world_from_beam.theta_rad);
    if (range_m > nearest_m.value_or(reach_m) || std::abs(off_axis_rad) > half_cone_rad) continue;
    const bool is_seen = !cast_ray(obstacles.edges, world_from_beam.position(), offset / range_m,
                                   range_m - kBehindCornerM);
    if (is_seen) nearest_m = range_m;
  }
  return nearest_m;
}

}  // namespace

std::optional<double> echo_m(const Obstacles& obstacles, const Pose2& world_from_beam,
                             const RangeSensor& sensor, const SonarErrors& errors) {
  const bool is_sonar = sensor.kind == SensorKind::sonar;
  const double specular_limit_rad = radians(is_sonar ? errors.specular_limit_deg : 90.0);
  std::optional<double> nearest_m;
  const int rays = sensor.half_cone_rad > 0.0 ? kRaysPerCone : 1;
  for (int ray = 0; ray < rays; ++ray) {
    const double across = rays == 1 ? 0.0 : 2.0 * ray / (rays - 1) - 1.0;  // -1 to 1
    const double bearing_rad = world_from_beam.theta_rad + across * sensor.half_cone_rad;
    const auto hit = cast_ray(obstacles.edges, world_from_beam.position(), direction(bearing_rad),
                              sensor.max_range_m);
    if (!hit || hit->incidence_rad > specular_limit_rad) continue;
    if (!nearest_m || hit->range_m < *nearest_m) nearest_m = hit->range_m;
  }
  if (!is_sonar) return nearest_m;
  const auto corner_m =
      corner_echo_m(obstacles, world_from_beam, kCornerCone * sensor.half_cone_rad,
                    std::min(errors.corner_echo_m, sensor.max_range_m));
  return corner_m && (!nearest_m || *corner_m < *nearest_m) ? corner_m : nearest_m;
}

std::optional<double> echo_past_glass_m(const Obstacles& obstacles, const Pose2& world_from_beam,
                                        double max_range_m, const SilentWalls& silent) {
  const Point2 along = direction(world_from_beam.theta_rad);
  double from_m = 0.0;
  for (;;) {
    const Point2 origin = world_from_beam.position() + from_m * along;
    const auto hit = cast_ray(obstacles.edges, origin, along, max_range_m - from_m);
    if (!hit) return std::nullopt;
    const double range_m = from_m + hit->range_m;
    if (hit->edge >= obstacles.of_building) return range_m;
    const WallSurface surface = silent.at(world_from_beam.position() + range_m * along);
    if (surface == WallSurface::plain) return range_m;
    if (surface == WallSurface::black) return std::nullopt;
    from_m = range_m + kBehindGlassM;
  }
}

RangeReader::RangeReader(const SimulationOptions& options)
    : sonar_(options.sonar),
      laser_(options.laser),
      silent_(options.laser.silent_share, options.seed),
      range_noise_(options.seed, "sonar range"),
      dropout_(options.seed, "sonar dropout"),
      crosstalk_(options.seed, "crosstalk") {}

RangeReader::Echoes RangeReader::with_crosstalk(const Echoes& echoes_m) {
  Echoes heard_m = echoes_m;
  const std::size_t count = echoes_m.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double draw = crosstalk_.uniform();
    if (draw >= sonar_.crosstalk_share) continue;
    const bool left = draw < sonar_.crosstalk_share / 2.0;
    const auto& neighbor_m = echoes_m[(i + (left ? count - 1 : 1)) % count];
    if (neighbor_m && (!heard_m[i] || *neighbor_m < *heard_m[i])) heard_m[i] = neighbor_m;
  }
  return heard_m;
}

std::vector<float> RangeReader::read(const Obstacles& obstacles, const Pose2& world_from_robot,
                                     const RangeSensor& sensor) {
  const bool is_sonar = sensor.kind == SensorKind::sonar;
  Echoes echoes_m;
  for (const Pose2& robot_from_beam : sensor.robot_from_beam) {
    const Pose2 world_from_beam = world_from_robot * robot_from_beam;
    echoes_m.push_back(
        !is_sonar && silent_.exist()
            ? echo_past_glass_m(obstacles, world_from_beam, sensor.max_range_m, silent_)
            : echo_m(obstacles, world_from_beam, sensor, sonar_));
  }
  if (is_sonar) echoes_m = with_crosstalk(echoes_m);

  const double deviation_m = is_sonar ? sonar_.range_noise_m : laser_.range_noise_m;
  const double dropout_share = is_sonar ? sonar_.dropout_share : laser_.dropout_share;
  std::vector<float> ranges_m;
  for (const std::optional<double>& echo_m : echoes_m) {
    // Always one draw of each a beam: what one beam sees does not change another's noise.
    const double noise_m = deviation_m * range_noise_.normal();
    const bool lost = dropout_.uniform() < dropout_share;
    const double range_m = echo_m && !lost ? *echo_m + noise_m : sensor.max_range_m;
    ranges_m.push_back(range_m < sensor.max_range_m
                           ? static_cast<float>(std::max(range_m, kLeastRange_m))
                           : rounded_up(sensor.max_range_m));
  }
  return ranges_m;
}

}  // namespace roomatlas
