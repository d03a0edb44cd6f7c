// SPDX-License-Identifier: GPL-3.0-or-later
#include "open_log.hpp"

#include <utility>

#include "roomatlas/io/logs/open_mission.hpp"
#include "roomatlas/match/scan_odometry.hpp"

namespace roomatlas::apps {

std::unique_ptr<MissionSource> open_log(const std::filesystem::path& log,
                                        const MissionOptions& options) {
  auto mission = open_mission_to_map(log, options);
  const MissionInfo& info = mission->info();
  if (!info.recording || info.odometry != "none") return mission;
  ScanOdometryOptions matching;
  matching.turns_are_told = !info.recording->gyro_topic.empty();
  return scan_odometry(std::move(mission), matching);
}

}  // namespace roomatlas::apps
