// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "roomatlas/mission/mission.hpp"
#include "roomatlas/mission/part_of_mission.hpp"
#include "settings.hpp"

namespace roomatlas::apps {

/// Of a joined building: the digests of its missions, separated by spaces.
inline constexpr const char* kMissionsKey = "missions_sha256";

using Metadata = std::map<std::string, std::string>;

/// What the store remembers of the run that mapped it.
[[nodiscard]] Metadata metadata_of(const MissionInfo& info, const std::string& mission_sha256,
                                   const Settings& settings);
/// What decides it, known before the log is read: `is_mapped_from` compares it.
[[nodiscard]] Metadata origin_of(const std::string& mission_sha256, const Settings& settings);
/// The log's checksum, and which part of it where it is one: a mission's identity.
[[nodiscard]] std::string sha256_of_part(const std::filesystem::path& log, const MissionPart& part);
/// Reads them back; the defaults where a store lacks them.
[[nodiscard]] double path_length_of(const Metadata& metadata);
/// The mission's date as YYYY-MM-DD, from its first timestamp; empty where that is no Unix time of
/// the years 1990 to 2100.
[[nodiscard]] std::string date_of(const Metadata& metadata);

/// The digests of the missions that a store holds: one, or those that a building was joined from.
[[nodiscard]] std::set<std::string> missions_of(const Metadata& metadata);

/// What tells the building from others, on which identifiers of its rooms hang: the identity of
/// the mission whose frame is the building's. Kept when missions are joined to it.
[[nodiscard]] std::string building_of(const Metadata& metadata);

/// Whether a store can be of that building: of one into which nothing was mapped, or that was made
/// up, nobody knows.
[[nodiscard]] bool may_be_of(const Metadata& metadata, const std::string& building);

/// True when the store was finished from the same log by the same version, with the same
/// parameters as far as mapping uses them: then it need not be mapped again.
[[nodiscard]] bool is_mapped_from(const Metadata& metadata, const std::string& mission_sha256,
                                  const Settings& settings);

}  // namespace roomatlas::apps
