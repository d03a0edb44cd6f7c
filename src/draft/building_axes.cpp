// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/building_axes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "roomatlas/asr/load.hpp"
#include "roomatlas/draft/wall_faces.hpp"
#include "sonar_votes.hpp"

namespace roomatlas {
namespace {

constexpr double kEvery_m = 0.3;         // between sweeps that tell a direction ...
constexpr double kSonarsEvery_m = 0.06;  // ... of sonars, which have few beams: half a degree off
                                         // costs them walls
constexpr double kVotes_m = 3.0;         // farther echoes say little about where a wall is

/// What some of the sweeps say of the walls' directions.
class Directions {
 public:
  explicit Directions(const GatherOptions& options) : options_(options) {}

  void add(const RangeReading& reading, const Pose2& building_from_robot) {
    if (!first_) first_ = building_from_robot;
    const bool is_sonar = reading.sensor->kind == SensorKind::sonar;
    const double every_m = is_sonar ? kSonarsEvery_m : kEvery_m;
    if (last_ && (building_from_robot.position() - last_->position()).norm() < every_m) return;
    last_ = building_from_robot;
    if (is_sonar) {
      const std::vector<Echo> heard = echoes_of(reading, building_from_robot, options_);
      echoes_.insert(echoes_.end(), heard.begin(), heard.end());
      half_cone_rad_ = std::max(half_cone_rad_, reading.sensor->half_cone_rad);
    } else {
      const auto seen = surfaces_of(reading, building_from_robot, options_.laser_range_m);
      surfaces_.insert(surfaces_.end(), seen.begin(), seen.end());
    }
  }

  [[nodiscard]] Pose2 axes_from_building(int jobs) const {
    if (!first_) return {};
    double along_rad = first_->theta_rad;
    if (!echoes_.empty()) {
      along_rad = best_direction_rad(echoes_, half_cone_rad_, kVotes_m, jobs);
    } else if (!surfaces_.empty()) {
      along_rad = main_direction_rad(surfaces_);
    }
    const double quarters = std::round((first_->theta_rad - along_rad) / (kPi / 2.0));
    const Pose2 building_from_axes{first_->x_m, first_->y_m,
                                   wrap_angle(along_rad + quarters * kPi / 2.0)};
    return inverse(building_from_axes);
  }

 private:
  const GatherOptions& options_;
  std::optional<Pose2> first_;
  std::optional<Pose2> last_;
  std::vector<SurfacePoint> surfaces_;
  std::vector<Echo> echoes_;
  double half_cone_rad_ = 0.0;
};

}  // namespace

Pose2 axes_from_building(const AsrSource& source, const Placement& placement,
                         const GatherOptions& options, int jobs) {
  Directions directions(options);
  for (const AsrId id : source.ids()) {
    const Asr asr = load_with_readings(source, id);
    for (std::size_t k = 0; k < asr.path.size(); ++k) {
      directions.add(asr.readings[k], placement.at(id) * asr.path[k].asr_from_robot);
    }
  }
  return directions.axes_from_building(jobs);
}

Placement moved(Placement placement, const Pose2& to_from_here) {
  for (auto& [id, building_from_asr] : placement) {
    building_from_asr = to_from_here * building_from_asr;
  }
  return placement;
}

MappedBuilding moved(MappedBuilding building, const Pose2& to_from_here) {
  const auto move = [&](auto& shape) { shape = transformed(to_from_here, shape); };
  for (Door& door : building.doors) {
    door.frame_from_pivot = to_from_here * door.frame_from_pivot;
    move(door.jambs);
    if (door.leaf) move(*door.leaf);
  }
  for (PlacedOutline& outline : building.outlines) move(outline.outline);
  for (PlacedOutline& outline : building.measured_outlines) move(outline.outline);
  for (Polygon& body : building.wall_bodies) move(body);
  for (PlanFurniture& piece : building.furniture) move(piece.outline);
  for (PlanEdge& edge : building.edges) move(edge.line);
  return building;
}

}  // namespace roomatlas
