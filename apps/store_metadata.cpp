// SPDX-License-Identifier: GPL-3.0-or-later
#include "store_metadata.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <charconv>
#include <ctime>
#include <filesystem>
#include <iterator>
#include <sstream>

#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/results/summary.hpp"
#include "stored_configuration.hpp"

namespace roomatlas::apps {
namespace {

double number_in(const Metadata& metadata, const std::string& key, double otherwise) {
  const auto entry = metadata.find(key);
  if (entry == metadata.end()) return otherwise;
  double value = otherwise;
  std::from_chars(entry->second.data(), entry->second.data() + entry->second.size(), value);
  return value;
}

std::string text_of(double value) { return fmt::format("{}", value); }

}  // namespace

Metadata origin_of(const std::string& mission_sha256, const Settings& settings) {
  return {{"tool_version", ROOMATLAS_VERSION},
          {"configuration", settings.as_toml},
          {"mission_sha256", mission_sha256}};
}

Metadata metadata_of(const MissionInfo& info, const std::string& mission_sha256,
                     const Settings& settings) {
  Metadata metadata = {{"mission_file", std::filesystem::path(info.file).filename().string()},
                       {"mission_json", to_json(info)},
                       {"mission_path_length_m", text_of(info.path_length_m)},
                       {"mission_first_timestamp_s", text_of(info.first_timestamp_s.value_or(0.0))},
                       {"robot_length_m", text_of(info.footprint.length_m)},
                       {"robot_width_m", text_of(info.footprint.width_m)}};
  metadata.merge(origin_of(mission_sha256, settings));
  return metadata;
}

std::string sha256_of_part(const std::filesystem::path& log, const MissionPart& part) {
  const std::string sha256 = sha256_of_file(log);
  if (part.is_whole()) return sha256;
  return fmt::format("{}{}:{}-{}", sha256, part.suffix(), part.first, part.last);
}

double path_length_of(const Metadata& metadata) {
  return number_in(metadata, "mission_path_length_m", 0.0);
}

std::string date_of(const Metadata& metadata) {
  const double timestamp_s = number_in(metadata, "mission_first_timestamp_s", 0.0);
  constexpr double kYear1990 = 631152000.0;
  constexpr double kYear2100 = 4102444800.0;
  if (timestamp_s < kYear1990 || timestamp_s >= kYear2100) return "";
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(static_cast<std::time_t>(timestamp_s)));
}

std::string building_of(const Metadata& metadata) {
  for (const char* key : {"building", "mission_sha256", "mission_file"}) {
    const auto entry = metadata.find(key);
    if (entry != metadata.end()) return entry->second;
  }
  return "";
}

bool may_be_of(const Metadata& metadata, const std::string& building) {
  const bool is_known = metadata.contains("building") || metadata.contains("mission_sha256");
  return !is_known || (!building.empty() && building_of(metadata) == building);
}

std::set<std::string> missions_of(const Metadata& metadata) {
  const auto joined = metadata.find(kMissionsKey);
  const auto entry = joined == metadata.end() ? metadata.find("mission_sha256") : joined;
  if (entry == metadata.end()) return {};
  std::istringstream words(entry->second);
  return {std::istream_iterator<std::string>(words), {}};
}

bool is_mapped_from(const Metadata& metadata, const std::string& mission_sha256,
                    const Settings& settings) {
  const auto value = [&](const std::string& key) {
    const auto entry = metadata.find(key);
    return entry == metadata.end() ? std::string() : entry->second;
  };
  // Rooms that an assembly of a sonar mission mapped again are not those of the odometry any more.
  const bool has_its_rooms =
      settings.assemble.correct_sonars || !metadata.contains("rooms_configuration");
  return value("mission_sha256") == mission_sha256 && value("tool_version") == ROOMATLAS_VERSION &&
         map_alike(value("configuration"), settings.as_toml) && has_its_rooms;
}

}  // namespace roomatlas::apps
