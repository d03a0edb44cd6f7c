// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/bag_source.hpp"
#include "bags/recorded_poses.hpp"
#include "carmen_source.hpp"
#include "small_logs.hpp"

#include "roomatlas/io/files/input_file.hpp"
#include "roomatlas/io/logs/open_mission.hpp"
#include "roomatlas/mission/as_sonar.hpp"
#include "roomatlas/mission/clock_watch.hpp"
#include "roomatlas/mission/odometry_jumps.hpp"
#include "roomatlas/mission/one_sensor_kind.hpp"

#include <utility>

namespace roomatlas {
namespace {

std::unique_ptr<MissionSource> open_log(const Path& file, const MissionOptions& options) {
  require_regular_file(file);
  if (auto recording = io::open_recording(file, options)) return recording;
  if (const io::OpenLog open = io::find_small_log(file)) return open(file, options);
  return std::make_unique<io::CarmenSource>(file, options);
}

}  // namespace

std::unique_ptr<MissionSource> open_mission(const Path& file, const MissionOptions& options) {
  auto mission = open_log(file, options);
  if (options.as_sonar.enabled) {
    mission = as_sonar(std::move(mission), options.as_sonar, options.sonar_max_range_m);
  }
  return mission;
}

bool is_recording(const Path& file) {
  try {
    return io::is_recording(file);
  } catch (const InputError&) {
    return false;  // whoever reads it says what is wrong
  }
}

std::unique_ptr<MissionSource> open_mission_to_map(const Path& file,
                                                   const MissionOptions& options) {
  return with_clock_watched(without_odometry_jumps(one_sensor_kind(open_mission(file, options))));
}

}  // namespace roomatlas
