// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/evidence.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "roomatlas/asr/load.hpp"
#include "roomatlas/core/for_each_index.hpp"

namespace roomatlas {
namespace {

constexpr std::size_t kThinAt = 2'000'000;  // points; fewer thins more often, more needs memory

bool is_worth_it(const Pose2& from, const Pose2& to, double every_m, double every_deg) {
  return (to.position() - from.position()).norm() >= every_m ||
         std::abs(wrap_angle(to.theta_rad - from.theta_rad)) >= every_deg * kPi / 180.0;
}

using Surfaces = std::vector<SurfacePoint>;

/// A reading that is worth it, where the correction puts it.
struct Placed {
  const RangeReading* reading = nullptr;
  Pose2 building_from_robot;

  [[nodiscard]] bool is_sonar() const { return reading->sensor->kind == SensorKind::sonar; }
};

/// Takes readings in and makes evidence of them, one ASR after the other. Beams that are counted,
/// what is heard or seen, and keeping what was seen before are apart: each can be taken in a thread
/// of its own.
class Gatherer {
 public:
  Gatherer(const RobotFootprint& footprint, const GatherOptions& options) : options_(options) {
    evidence_.footprint = footprint;
    evidence_.counts = ReflectionMap(options.cell_m);
    evidence_.coarse = ReflectionMap(options.coarse_cell_m);
  }

  /// Of the readings of an ASR those that are worth it.
  [[nodiscard]] std::vector<Placed> begin(const Asr& asr, const Pose2& building_from_asr) {
    std::vector<Placed> worth_it;
    for (std::size_t i = 0; i < asr.path.size(); ++i) {
      const Placed placed{&asr.readings[i], building_from_asr * asr.path[i].asr_from_robot};
      const Pose2& pose = placed.building_from_robot;
      evidence_.building_from_robot.push_back(pose);
      evidence_.asr_of_pose.push_back(asr.id);
      if (placed.is_sonar()) evidence_.kind = SensorKind::sonar;
      const double every_m = placed.is_sonar() ? options_.sonar_every_m : options_.laser_every_m;
      if (last_ && !is_worth_it(*last_, pose, every_m, options_.every_deg)) continue;
      last_ = pose;
      worth_it.push_back(placed);
    }
    return worth_it;
  }

  void count(const std::vector<Placed>& readings) {
    std::int64_t ignored = 0;  // counted when each room was mapped
    for (const Placed& one : readings) {
      const RayOptions rays{one.is_sonar() ? options_.sonar_range_m : options_.laser_range_m,
                            options_.sonar_no_echo_m, 0.0};
      evidence_.counts.add_sweep(rays_of(*one.reading, one.building_from_robot, rays, ignored));
    }
  }

  /// @returns what each laser's reading saw, to be kept
  [[nodiscard]] std::vector<Surfaces> hear_and_see(const std::vector<Placed>& readings) {
    std::int64_t ignored = 0;
    std::vector<Surfaces> seen;
    for (const Placed& one : readings) {
      if (!one.is_sonar()) {
        seen.push_back(surfaces_of(*one.reading, one.building_from_robot, options_.laser_range_m));
        continue;
      }
      const RayOptions far{options_.coarse_range_m, options_.sonar_no_echo_m, 0.0};
      evidence_.coarse.add_sweep(rays_of(*one.reading, one.building_from_robot, far, ignored));
      add_echoes(*one.reading, one.building_from_robot);
    }
    return seen;
  }

  void keep(const std::vector<Surfaces>& seen) {
    Surfaces& all = evidence_.surfaces;
    for (const Surfaces& of_one : seen) {
      all.insert(all.end(), of_one.begin(), of_one.end());
      if (all.size() <= thin_at_) continue;
      all = thinned(std::move(all));
      thin_at_ = all.size() + kThinAt;
    }
  }

  BuildingEvidence taken() {
    evidence_.surfaces = thinned(std::move(evidence_.surfaces));
    return std::move(evidence_);
  }

 private:
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
  const PointTransform place(building_from_robot);
  std::vector<Echo> echoes;
  for (std::size_t i = 0; i < reading.ranges_m.size(); ++i) {
    const double range_m = reading.ranges_m[i];
    if (!std::isfinite(range_m) || range_m <= 0.0) continue;
    const bool is_hit = range_m < sensor.max_range_m;
    const bool is_near = is_hit && range_m <= options.sonar_range_m;
    const double free_m =
        is_near ? range_m : std::min({range_m, options.sonar_range_m, options.sonar_no_echo_m});
    echoes.push_back(
        {place.pose(building_from_robot, sensor.robot_from_beam[i]), range_m, is_hit, free_m});
  }
  return echoes;
}

void add_seen(const BuildingEvidence& more, BuildingEvidence& evidence) {
  const auto append = [](const auto& from, auto& to) {
    to.insert(to.end(), from.begin(), from.end());
  };
  evidence.counts.add(more.counts);
  append(more.surfaces, evidence.surfaces);
  evidence.surfaces = thinned(std::move(evidence.surfaces));
  append(more.building_from_robot, evidence.building_from_robot);
  append(more.asr_of_pose, evidence.asr_of_pose);
}

BuildingEvidence gather_evidence(const AsrSource& source, const Placement& placement,
                                 const RobotFootprint& footprint, const GatherOptions& options,
                                 const Progress& progress, int jobs) {
  Gatherer gatherer(footprint, options);
  const std::vector<AsrId> ids = source.ids();
  std::optional<Asr> next;
  if (!ids.empty()) next = load_with_readings(source, ids.front());
  std::vector<Surfaces> seen;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    report(progress, "map building", share_of(i, ids.size()));
    const Asr asr = std::move(*next);
    const std::vector<Placed> readings = gatherer.begin(asr, placement.at(asr.id));
    std::vector<Surfaces> seen_now;
    for_each_index(4, jobs, [&](std::size_t part) {
      if (part == 0) gatherer.keep(seen);  // now and then the longest
      if (part == 1) seen_now = gatherer.hear_and_see(readings);
      if (part == 2) gatherer.count(readings);
      if (part == 3 && i + 1 < ids.size()) next = load_with_readings(source, ids[i + 1]);
    });
    seen = std::move(seen_now);
  }
  gatherer.keep(seen);
  return gatherer.taken();
}

}  // namespace roomatlas
