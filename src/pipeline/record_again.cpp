// SPDX-License-Identifier: GPL-3.0-or-later
#include "record_again.hpp"

#include <algorithm>

namespace roomatlas {

std::vector<RangeReading> sonar_readings_of(const AsrSource& source) {
  std::vector<RangeReading> readings;
  for (const AsrId id : source.ids()) {
    Asr asr = source.get(id, AsrDetail::readings);
    const bool all_sonar =
        !asr.readings.empty() &&
        std::all_of(asr.readings.begin(), asr.readings.end(), [](const RangeReading& reading) {
          return reading.sensor->kind == SensorKind::sonar;
        });
    if (!all_sonar) return {};
    std::move(asr.readings.begin(), asr.readings.end(), std::back_inserter(readings));
  }
  return readings;
}

RecordedAgain record_again(const std::vector<RangeReading>& readings,
                           const std::vector<Pose2>& map_from_robot,
                           const RobotFootprint& footprint, const RecorderOptions& options) {
  RecordedAgain again;
  AsrRecorder recorder(options, footprint, again.asrs);
  for (std::size_t i = 0; i < readings.size(); ++i) recorder.add(readings[i], map_from_robot[i]);
  recorder.finish();
  std::size_t first = 0;  // reading of the ASR
  for (Asr& asr : again.asrs.asrs) {
    asr.is_localized = true;
    again.placement[asr.id] = map_from_robot[first] * inverse(asr.path.front().asr_from_robot);
    first += asr.path.size();
  }
  return again;
}

}  // namespace roomatlas
