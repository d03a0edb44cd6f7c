// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/locate/place_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace roomatlas {
namespace {

/// One query at one place.
class Teller {
 public:
  Teller(const SeenBuilding& building, const Pose2& place, const PlaceEvidenceOptions& options)
      : building_(building),
        place_(place),
        to_(place),
        turn_(Pose2{0.0, 0.0, place.theta_rad}),
        options_(options) {}

  [[nodiscard]] Told wall(const ScanPoint& wall) const {
    const Point2 at = to_ * wall.position;
    if (building_.distance_to_wall(at, turn_ * wall.normal, options_.agree_m)) return Told::agrees;
    return building_.is_floor(at) ? Told::contradicts : Told::nothing;
  }

  [[nodiscard]] Told floor(const Point2& floor) const {
    const Point2 at = to_ * floor;
    if (building_.is_floor(at)) return Told::agrees;
    return building_.has_wall_in(at) ? Told::contradicts : Told::nothing;
  }

  [[nodiscard]] Told ray(const QueryRay& ray) const {
    return ray.half_cone_rad > 0.0 ? sonar(ray) : laser(ray);
  }

 private:
  /// A laser's ray, and its neighbours: near an edge they see different walls. What stands about
  /// may have gone since, or come; a stretch of wall that a ray passes through speaks against it.
  [[nodiscard]] Told laser(const QueryRay& ray) const {
    const double beyond_m = ray.range_m + options_.ray_off_m;
    bool ends_at_wall = false;
    bool is_stopped = true;
    bool is_in_the_open = true;
    for (const double turn_rad : {-options_.beside_rad, 0.0, options_.beside_rad}) {
      const SeenBuilding::Met met = cast(ray, turn_rad);
      const double off_m = met.range_m - ray.range_m;
      ends_at_wall = ends_at_wall || (met.is_wall && std::abs(off_m) < options_.ray_off_m / 2.0);
      is_stopped = is_stopped && met.is_wall && off_m < -options_.ray_off_m;
      is_in_the_open = is_in_the_open && !met.is_wall && met.range_m >= beyond_m;
    }
    if (ray.is_echo && ends_at_wall) return Told::agrees;
    if (ray.is_echo && is_in_the_open) return Told::contradicts;
    return is_stopped && passes_wall(ray) ? Told::contradicts : Told::nothing;
  }

  [[nodiscard]] bool passes_wall(const QueryRay& ray) const {
    const double before_m = ray.range_m - options_.ray_off_m;
    const auto is_passed = [&](double turn_rad) {
      return building_.cast_to_stretch(beam(ray, turn_rad), before_m).is_wall;
    };
    return is_passed(-options_.beside_rad) && is_passed(0.0) && is_passed(options_.beside_rad);
  }

  /// A sonar's cone: a wall across it that looks at the sonar must give an echo, one that does not
  /// may; without any wall there is none.
  [[nodiscard]] Told sonar(const QueryRay& ray) const {
    const double agree_m = options_.ray_off_m / 2.0;
    const double beyond_m = ray.range_m + options_.ray_off_m;
    double nearest_m = beyond_m;
    double facing_m = beyond_m;
    bool ends_at_wall = false;
    bool is_known = true;
    std::optional<double> beside_m;  // the neighbour, where it meets a wall that looks here
    for (int i = 0; i < options_.cone_rays; ++i) {
      const double across = 2.0 * i / (options_.cone_rays - 1) - 1.0;
      const SeenBuilding::Met met = cast(ray, across * ray.half_cone_rad);
      is_known = is_known && (met.is_wall || met.range_m >= beyond_m);
      const bool is_facing = met.is_wall && met.facing > options_.facing_cosine;
      if (is_facing && beside_m && std::abs(*beside_m - met.range_m) < agree_m) {
        facing_m = std::min(facing_m, std::max(*beside_m, met.range_m));
      }
      beside_m = is_facing ? std::optional<double>(met.range_m) : std::nullopt;
      if (!met.is_wall) continue;
      nearest_m = std::min(nearest_m, met.range_m);
      ends_at_wall = ends_at_wall || std::abs(met.range_m - ray.range_m) < agree_m;
    }
    if (facing_m < ray.range_m - options_.ray_off_m) return Told::contradicts;
    if (!ray.is_echo) return Told::nothing;
    if (ends_at_wall) return Told::agrees;
    return is_known && nearest_m > ray.range_m + agree_m ? Told::contradicts : Told::nothing;
  }

  [[nodiscard]] SeenBuilding::Met cast(const QueryRay& ray, double turn_rad) const {
    return building_.cast(beam(ray, turn_rad), ray.range_m + options_.ray_off_m);
  }
  [[nodiscard]] Pose2 beam(const QueryRay& ray, double turn_rad) const {
    return place_ * ray.query_from_beam * Pose2{0.0, 0.0, turn_rad};
  }

  const SeenBuilding& building_;
  Pose2 place_;
  PointTransform to_;
  PointTransform turn_;
  const PlaceEvidenceOptions& options_;
};

}  // namespace

void add_evidence(const AskedVisit& visit, const SeenBuilding& building,
                  const Pose2& building_from_asr, const PlaceEvidenceOptions& options,
                  PlaceEvidence& evidence) {
  const Teller teller(building, building_from_asr, options);
  for (const ScanPoint& wall : visit.sketch.walls) evidence.walls.push_back(teller.wall(wall));
  for (const Point2& at : visit.sketch.floor) evidence.floor.push_back(teller.floor(at));
  for (const QueryRay& ray : visit.rays) evidence.rays.push_back(teller.ray(ray));
}

}  // namespace roomatlas
