// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <optional>

#include "roomatlas/asr/map_room.hpp"

namespace roomatlas {
namespace {

constexpr double kJambSlackM = 0.1;     // rays this far outside of a jamb still count as through
constexpr double kOutsideDepthM = 1.0;  // a sensor is in the doorway's other room up to here

/// Coordinates relative to a doorway: x outwards, y along the door line.
Point2 relative_to(const Exit& exit, const Point2& point_asr) {
  return inverse(exit.frame_from_pivot) * point_asr;
}

}  // namespace

RayOptions ray_options(const RoomMapOptions& options) {
  return {options.max_mapped_range_m, options.sonar_no_echo_m, options.laser_no_echo_m};
}

bool moved_enough(const Pose2& from, const Pose2& to, const RoomMapOptions& options) {
  return (to.position() - from.position()).norm() >= options.insert_every_m ||
         std::abs(wrap_angle(to.theta_rad - from.theta_rad)) >= radians(options.insert_every_deg);
}

std::optional<Ray> clipped_at_doorway(const Ray& ray, const Exit& exit) {
  const Point2 a = relative_to(exit, ray.segment.a);
  const Point2 b = relative_to(exit, ray.segment.b);
  const double half_m = exit.width_m / 2.0 + kJambSlackM;
  const bool starts_outside =
      a.x() > 0.0 && a.x() < kOutsideDepthM && std::abs(a.y()) < half_m + kOutsideDepthM;
  if ((a.x() > 0.0) == (b.x() > 0.0)) {
    return starts_outside ? std::nullopt : std::optional<Ray>(ray);
  }
  const double fraction = a.x() / (a.x() - b.x());
  const bool through = std::abs(a.y() + fraction * (b.y() - a.y())) <= half_m;
  if (!through) return starts_outside ? std::nullopt : std::optional<Ray>(ray);
  const Point2 at_door = ray.segment.a + fraction * (ray.segment.b - ray.segment.a);
  if (a.x() > 0.0) return Ray{{at_door, ray.segment.b}, ray.ends_at_obstacle};
  return Ray{{ray.segment.a, at_door}, false};
}

HimmGrid himm_of_room(const std::vector<PathSample>& path,
                      const std::vector<RangeReading>& readings, const std::vector<Exit>& exits,
                      const RobotFootprint& footprint, const RoomMapOptions& options,
                      std::int64_t& ignored_ranges) {
  HimmGrid grid(options.cell_m);
  std::optional<Pose2> last_inserted;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Pose2& asr_from_robot = path[i].asr_from_robot;
    if (last_inserted && !moved_enough(*last_inserted, asr_from_robot, options)) continue;
    last_inserted = asr_from_robot;
    std::vector<Ray> rays =
        rays_of(readings[i], asr_from_robot, ray_options(options), ignored_ranges);
    for (const Exit& exit : exits) {
      if (exit.kind != PassageKind::doorway) continue;
      std::vector<Ray> inside;
      inside.reserve(rays.size());
      for (const Ray& ray : rays) {
        if (const auto clipped = clipped_at_doorway(ray, exit)) inside.push_back(*clipped);
      }
      rays = std::move(inside);
    }
    grid.add_sweep(rays);
    grid.mark_robot(asr_from_robot, footprint);
  }
  return grid;
}

}  // namespace roomatlas
