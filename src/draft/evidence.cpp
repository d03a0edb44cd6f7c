// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/evidence.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "roomatlas/asr/load.hpp"

namespace roomatlas {
namespace {

constexpr std::size_t kThinAt = 2'000'000;  // points; fewer thins more often, more needs memory

bool is_worth_it(const Pose2& from, const Pose2& to, double every_m, double every_deg) {
  return (to.position() - from.position()).norm() >= every_m ||
         std::abs(wrap_angle(to.theta_rad - from.theta_rad)) >= every_deg * kPi / 180.0;
}

/// Takes readings in and makes evidence of them.
class Gatherer {
 public:
  Gatherer(const RobotFootprint& footprint, const GatherOptions& options) : options_(options) {
    evidence_.footprint = footprint;
    evidence_.counts = ReflectionMap(options.cell_m);
    evidence_.coarse = ReflectionMap(options.coarse_cell_m);
  }

  void add(AsrId asr, const RangeReading& reading, const Pose2& building_from_robot) {
    evidence_.building_from_robot.push_back(building_from_robot);
    evidence_.asr_of_pose.push_back(asr);
    const bool is_sonar = reading.sensor->kind == SensorKind::sonar;
    if (is_sonar) evidence_.kind = SensorKind::sonar;
    const double every_m = is_sonar ? options_.sonar_every_m : options_.laser_every_m;
    if (last_ && !is_worth_it(*last_, building_from_robot, every_m, options_.every_deg)) return;
    last_ = building_from_robot;
    std::int64_t ignored = 0;  // counted when each room was mapped
    const RayOptions rays{is_sonar ? options_.sonar_range_m : options_.laser_range_m,
                          options_.sonar_no_echo_m, 0.0};
    evidence_.counts.add_sweep(rays_of(reading, building_from_robot, rays, ignored));
    if (is_sonar) {
      const RayOptions far{options_.coarse_range_m, options_.sonar_no_echo_m, 0.0};
      evidence_.coarse.add_sweep(rays_of(reading, building_from_robot, far, ignored));
      add_echoes(reading, building_from_robot);
    } else {
      add_surfaces(reading, building_from_robot);
    }
  }

  BuildingEvidence taken() {
    evidence_.surfaces = thinned(std::move(evidence_.surfaces));
    return std::move(evidence_);
  }

 private:
  void add_surfaces(const RangeReading& reading, const Pose2& building_from_robot) {
    std::vector<SurfacePoint> seen =
        surfaces_of(reading, building_from_robot, options_.laser_range_m);
    auto& all = evidence_.surfaces;
    all.insert(all.end(), seen.begin(), seen.end());
    if (all.size() > thin_at_) {
      all = thinned(std::move(all));
      thin_at_ = all.size() + kThinAt;
    }
  }

  void add_echoes(const RangeReading& reading, const Pose2& building_from_robot) {
    evidence_.sonar_half_cone_rad =
        std::max(evidence_.sonar_half_cone_rad, reading.sensor->half_cone_rad);
    const std::vector<Echo> heard = echoes_of(reading, building_from_robot, options_);
    evidence_.echoes.insert(evidence_.echoes.end(), heard.begin(), heard.end());
  }

  GatherOptions options_;
  BuildingEvidence evidence_;
  std::optional<Pose2> last_;
  std::size_t thin_at_ = kThinAt;
};

}  // namespace

std::vector<Echo> echoes_of(const RangeReading& reading, const Pose2& building_from_robot,
                            const GatherOptions& options) {
  const RangeSensor& sensor = *reading.sensor;
  std::vector<Echo> echoes;
  for (std::size_t i = 0; i < reading.ranges_m.size(); ++i) {
    const double range_m = reading.ranges_m[i];
    if (!std::isfinite(range_m) || range_m <= 0.0) continue;
    const bool is_hit = range_m < sensor.max_range_m;
    const bool is_near = is_hit && range_m <= options.sonar_range_m;
    const double free_m =
        is_near ? range_m : std::min({range_m, options.sonar_range_m, options.sonar_no_echo_m});
    echoes.push_back({building_from_robot * sensor.robot_from_beam[i], range_m, is_hit, free_m});
  }
  return echoes;
}

BuildingEvidence gather_evidence(const AsrSource& source, const Placement& placement,
                                 const RobotFootprint& footprint, const GatherOptions& options,
                                 const Progress& progress) {
  Gatherer gatherer(footprint, options);
  const std::vector<AsrId> ids = source.ids();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    report(progress, "map building", share_of(i, ids.size()));
    const Asr asr = load_with_readings(source, ids[i]);
    for (std::size_t k = 0; k < asr.path.size(); ++k) {
      gatherer.add(asr.id, asr.readings[k], placement.at(asr.id) * asr.path[k].asr_from_robot);
    }
  }
  return gatherer.taken();
}

}  // namespace roomatlas
