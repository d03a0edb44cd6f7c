// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/pipeline/mission_map.hpp"

#include <algorithm>
#include <utility>

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

}  // namespace

MissionMap mission_map_of(const AsrSource& source, const Placement& placement,
                          const Options& options) {
  const std::vector<AsrId> ids = source.ids();
  const SharedSource shared(source);
  struct Shaped {
    AsrShape shape;
    bool is_sonar = false;
  };
  std::vector<Shaped> shaped = results_of<Shaped>(ids.size(), options.jobs, [&](std::size_t i) {
    const Asr asr = shared.load_with_readings(ids[i]);
    if (is_by_sonars(asr)) return Shaped{sonar_shape_of(asr, options.sonar_shapes), true};
    return Shaped{shape_of(asr, options.map.localize, options.assemble.closures.match), false};
  });
  MissionMap map;
  map.mission_from_asr = placement;
  std::size_t sonars = 0;
  for (Shaped& one : shaped) {
    sonars += one.is_sonar ? 1 : 0;
    map.shapes.push_back(std::move(one.shape));
  }
  if (2 * sonars > shaped.size()) map.sensor = SensorKind::sonar;
  return map;
}

}  // namespace roomatlas
