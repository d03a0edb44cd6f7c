// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/asr_evidence.hpp"

#include <algorithm>
#include <cmath>

#include "roomatlas/asr/shared_source.hpp"
#include "roomatlas/core/for_each_index.hpp"

namespace roomatlas {
namespace {

constexpr double kWallBesideM = 0.15;  ///< an outline this near a wall runs along it
constexpr double kOneDirection = 0.5;  ///< walls whose directions agree at least so well

/// Every how many of `count` to take so that at most `wanted` are.
std::size_t stride_for(std::size_t count, int wanted) {
  const auto most = static_cast<std::size_t>(std::max(wanted, 1));
  return std::max<std::size_t>(1, (count + most - 1) / most);
}

/// The ray of one beam; nothing where it measured nothing.
std::optional<MeasuredRay> ray_of(const RangeSensor& sensor, const Pose2& asr_from_beam,
                                  double range_m, const EvidenceOptions& options) {
  if (!std::isfinite(range_m) || range_m <= 0.0) return std::nullopt;
  const double believed_m =
      sensor.kind == SensorKind::laser ? options.laser_range_m : options.sonar_range_m;
  const bool has_echo = range_m < sensor.max_range_m;
  const double length_m = has_echo ? std::min(range_m, believed_m) : options.no_echo_m;
  const Segment2 segment{asr_from_beam.position(), asr_from_beam * Point2(length_m, 0.0)};
  return MeasuredRay{segment, has_echo && range_m <= believed_m};
}

std::vector<MeasuredRay> sampled_rays(const Asr& asr, const EvidenceOptions& options) {
  std::vector<MeasuredRay> rays;
  const std::size_t sweeps = std::min(asr.path.size(), asr.readings.size());
  const std::size_t sweep_stride = stride_for(sweeps, options.sweeps_per_asr);
  for (std::size_t i = 0; i < sweeps; i += sweep_stride) {
    const RangeReading& reading = asr.readings[i];
    const RangeSensor& sensor = *reading.sensor;
    const std::size_t beams = std::min(reading.ranges_m.size(), sensor.robot_from_beam.size());
    const std::size_t beam_stride = stride_for(beams, options.beams_per_sweep);
    // Another first beam in each sweep, so that in the end all beams take part.
    const std::size_t first = (i / sweep_stride) % beam_stride;
    for (std::size_t beam = first; beam < beams; beam += beam_stride) {
      const Pose2 asr_from_beam = asr.path[i].asr_from_robot * sensor.robot_from_beam[beam];
      const auto ray = ray_of(sensor, asr_from_beam, reading.ranges_m[beam], options);
      if (ray) rays.push_back(*ray);
    }
  }
  return rays;
}

std::vector<Segment2> edges_of(const Asr& asr, bool fitted_only) {
  std::vector<Segment2> edges;
  for (const WallPolyline& wall : asr.walls) {
    for (std::size_t i = 1; i < wall.vertices_asr.size(); ++i) {
      if (fitted_only && i <= wall.edge_is_fitted.size() && !wall.edge_is_fitted[i - 1]) continue;
      edges.push_back({wall.vertices_asr[i - 1], wall.vertices_asr[i]});
    }
  }
  return edges;
}

/// Samples of the outline that lie along a wall; the outline runs counter-clockwise.
std::vector<SurfaceSample> surfaces_of(const Ring& outline, const std::vector<Segment2>& walls,
                                       double step_m) {
  std::vector<SurfaceSample> samples;
  const double turn = signed_area(outline) < 0.0 ? -1.0 : 1.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point2& a = outline[i];
    const Point2 along = outline[(i + 1) % outline.size()] - a;
    const double length_m = along.norm();
    if (!(length_m > 0.0)) continue;
    const Point2 unit = along / length_m;
    for (double at_m = step_m / 2.0; at_m < length_m; at_m += step_m) {
      const Point2 point = a + at_m * unit;
      const bool beside_wall = std::any_of(walls.begin(), walls.end(), [&](const Segment2& wall) {
        return distance(wall, point) <= kWallBesideM;
      });
      if (beside_wall) samples.push_back({point, turn * Point2(unit.y(), -unit.x())});
    }
  }
  return samples;
}

/// The mean direction modulo a right angle, each wall counted by its length.
std::optional<double> direction_of(const std::vector<Segment2>& walls) {
  Point2 sum = Point2::Zero();
  double length_m = 0.0;
  for (const Segment2& wall : walls) {
    const Point2 along = wall.b - wall.a;
    length_m += along.norm();
    sum += along.norm() * direction(4.0 * std::atan2(along.y(), along.x()));
  }
  if (length_m < 2.0 || sum.norm() < kOneDirection * length_m) return std::nullopt;
  return std::atan2(sum.y(), sum.x()) / 4.0;
}

}  // namespace

AsrEvidence evidence_of(const Asr& asr, const EvidenceOptions& options) {
  AsrEvidence evidence;
  evidence.asr = asr.id;
  evidence.exits = asr.exits;
  evidence.rays = sampled_rays(asr, options);
  evidence.has_readings = !evidence.rays.empty();
  evidence.seen = SeenSpace(evidence.rays, options.cell_m);
  evidence.walls = edges_of(asr, true);
  evidence.surfaces = surfaces_of(asr.outline_asr.outer, edges_of(asr, false), options.step_m);
  evidence.wall_direction_rad = direction_of(evidence.walls);
  evidence.outline = asr.outline_asr;
  return evidence;
}

std::vector<AsrEvidence> evidence_of(const AsrSource& source, const EvidenceOptions& options,
                                     int jobs) {
  const std::vector<AsrId> ids = source.ids();
  const SharedSource shared(source);
  return results_of<AsrEvidence>(ids.size(), jobs, [&](std::size_t i) {
    return evidence_of(shared.get(ids[i], AsrDetail::readings), options);
  });
}

}  // namespace roomatlas
