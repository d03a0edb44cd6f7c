// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/pipeline/mission_map.hpp"

#include <algorithm>
#include <iterator>

#include "roomatlas/asr/load.hpp"
#include "roomatlas/asr/shared_source.hpp"
#include "roomatlas/core/for_each_index.hpp"

namespace roomatlas {
namespace {

bool is_by_sonars(const Asr& asr) {
  return std::all_of(asr.readings.begin(), asr.readings.end(), [](const RangeReading& reading) {
    return reading.sensor->kind == SensorKind::sonar;
  });
}

/// As many readings of a mission as its place needs to be judged.
QueryRayOptions spread_over(const AsrSource& source, const std::vector<AsrId>& ids) {
  constexpr double kMostReadings = 200.0;
  double way_m = 0.0;
  for (const AsrId id : ids) way_m += path_length_m(source.get(id, AsrDetail::path));
  QueryRayOptions options;
  options.every_m = std::max(options.every_m, way_m / kMostReadings);
  return options;
}

}  // namespace

AsrShape shape_of_visit(const Asr& asr, const Options& options) {
  return is_by_sonars(asr) ? sonar_shape_of(asr, options.sonar_shapes)
                           : shape_of(asr, options.map.localize, options.assemble.closures.match);
}

MissionMap mission_map_of(const AsrSource& source, const Placement& placement,
                          const Options& options) {
  const std::vector<AsrId> ids = source.ids();
  const SharedSource shared(source);
  const QueryRayOptions spread = spread_over(source, ids);
  std::vector<char> by_sonars(ids.size(), 0);
  std::vector<std::vector<QueryRay>> rays(ids.size());
  MissionMap map;
  map.mission_from_asr = placement;
  map.shapes = results_of<AsrShape>(ids.size(), options.jobs, [&](std::size_t i) {
    const Asr asr = shared.load_with_readings(ids[i]);
    by_sonars[i] = is_by_sonars(asr) ? 1 : 0;
    rays[i] = rays_of(asr, spread);
    return shape_of_visit(asr, options);
  });
  for (std::size_t i = 0; i < ids.size(); ++i) map.rays[ids[i]] = std::move(rays[i]);
  const auto sonars = std::count(by_sonars.begin(), by_sonars.end(), 1);
  if (2 * sonars > std::ssize(ids)) map.sensor = SensorKind::sonar;
  return map;
}

}  // namespace roomatlas
