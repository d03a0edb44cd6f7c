// SPDX-License-Identifier: GPL-3.0-or-later
#include "mission_parts.hpp"

#include <spdlog/spdlog.h>

#include <filesystem>

#include "console.hpp"
#include "roomatlas/io/logs/open_mission.hpp"

namespace roomatlas::apps {

std::vector<MissionPart> parts_between(const std::vector<Kidnapping>& kidnappings) {
  if (kidnappings.empty()) return {MissionPart{}};
  std::vector<MissionPart> parts;
  std::int64_t first = 0;
  for (const Kidnapping& one : kidnappings) {
    parts.push_back({static_cast<int>(parts.size()) + 1, first, one.reading - 1});
    first = one.reading;
  }
  MissionPart rest;
  rest.number = static_cast<int>(parts.size()) + 1;
  rest.first = first;
  parts.push_back(rest);
  return parts;
}

std::vector<Kidnapping> kidnappings_in(const Settings& settings, MissionSource& mission) {
  if (!settings.map.kidnapping.enabled) return {};
  const Progress progress = console_progress(settings);
  constexpr int kReportEvery = 256;
  KidnappingFinder finder(settings.map.kidnapping);
  int events = 0;
  while (const auto event = mission.next()) {
    if (const auto* reading = std::get_if<RangeReading>(&*event)) finder.add(*reading);
    if (++events % kReportEvery == 0 && !progress("look for kidnappings", mission.progress())) {
      throw Interrupted("interrupted while looking for kidnappings");
    }
  }
  if (mission.info().odometry == "none") return {};  // what the sweeps tell is all that there is
  for (const Kidnapping& one : finder.found()) {
    spdlog::warn(
        "{}: the robot was carried away between {} and {} s: what it saw before and after is not "
        "one course ({:.0f} % agrees at best); the mission is cut there",
        mission.info().file, one.before_s, one.after_s, 100.0 * one.agreement);
  }
  return finder.found();
}

std::vector<LogPart> parts_of(const Settings& settings, const std::vector<Path>& logs) {
  std::vector<LogPart> parts;
  for (const Path& log : logs) {
    const auto mission = open_mission_to_map(log, settings.mission);
    for (const MissionPart& part : parts_between(kidnappings_in(settings, *mission))) {
      parts.push_back({log, part});
    }
  }
  return parts;
}

}  // namespace roomatlas::apps
