// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace roomatlas::test {

/// The files of a ZIP archive whose entries are stored without compression.
std::map<std::string, std::string> unzipped(const std::string& zip);

/// The files of an IMDF archive, parsed.
using ImdfFiles = std::map<std::string, nlohmann::json>;
ImdfFiles imdf_files(const std::string& zip);

/// The features of one type; empty where there is no such file.
std::vector<nlohmann::json> imdf_features(const ImdfFiles& files, const std::string& type);

/// Rules of OGC 20-094 that the archive breaks, a sentence each: members and their types, allowed
/// categories, geometry types, references, identifiers, and what must lie in what. Lengths are
/// taken near the equator or not: by the latitude of the first position.
std::vector<std::string> broken_imdf_rules(const ImdfFiles& files);

}  // namespace roomatlas::test
