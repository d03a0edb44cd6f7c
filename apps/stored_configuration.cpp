// SPDX-License-Identifier: GPL-3.0-or-later
#include "stored_configuration.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>
#include <CLI/CLI.hpp>

#include <sstream>
#include <vector>

namespace roomatlas::apps {
namespace {

struct Line {
  std::string name;
  std::string text;
};

/// A stored configuration has one parameter a line, without sections.
std::vector<Line> lines_of(const std::string& toml) {
  std::vector<Line> lines;
  std::istringstream in(toml);
  for (std::string text; std::getline(in, text);) {
    if (!text.empty()) lines.push_back({text.substr(0, text.find_first_of(" =")), text});
  }
  return lines;
}

std::map<std::string, std::string> mapping_lines(const std::string& toml) {
  CLI::App app;
  Settings unused;
  add_parameters(app, unused);
  std::map<std::string, std::string> lines;
  for (const Line& line : lines_of(toml)) {
    const CLI::Option* option = app.get_option_no_throw("--" + line.name);
    if (option == nullptr) continue;
    const std::string& stage = option->get_group();
    if (stage == kMissionStage || stage == kRoomsStage) lines[line.name] = line.text;
  }
  return lines;
}

/// The settings with one stage's parameters from a configuration.
Settings with_stage(const Settings& settings, const std::string& stage, const std::string& toml,
                    const std::string& store) {
  Settings stored = settings;
  CLI::App app;
  add_parameters(app, stored);
  std::string chosen;
  std::vector<std::string> unknown;
  for (const Line& line : lines_of(toml)) {
    const CLI::Option* option = app.get_option_no_throw("--" + line.name);
    if (option == nullptr) {
      unknown.push_back(line.name);
    } else if (option->get_group() == stage && !settings.given.contains(line.name)) {
      chosen += line.text + '\n';
    }
  }
  if (!unknown.empty()) {
    spdlog::warn("{}: it was made with parameters that this version does not know: {}", store,
                 fmt::join(unknown, ", "));
  }
  try {
    std::istringstream in(chosen);
    app.parse_from_stream(in);
    return stored;
  } catch (const CLI::ParseError& error) {
    spdlog::warn(
        "{}: this version cannot read the parameters that it was made with, those of this run "
        "hold: {}",
        store, error.what());
    return settings;
  }
}

/// The first of these keys that the store has.
std::string first_of(const Metadata& metadata, const std::vector<const char*>& keys) {
  for (const char* key : keys) {
    const auto entry = metadata.find(key);
    if (entry != metadata.end()) return entry->second;
  }
  return "";
}

}  // namespace

bool map_alike(const std::string& one, const std::string& other) {
  return mapping_lines(one) == mapping_lines(other);
}

Settings as_mapped(const Settings& settings, const Metadata& metadata,
                   const std::filesystem::path& store) {
  const std::string toml = first_of(metadata, {"rooms_configuration", "configuration"});
  return with_stage(settings, kRoomsStage, toml, store.string());
}

Settings as_corrected(const Settings& settings, const Metadata& metadata,
                      const std::filesystem::path& store) {
  const std::string toml = first_of(metadata, {"assembly_configuration", "configuration"});
  return with_stage(settings, kCorrectionStage, toml, store.string());
}

}  // namespace roomatlas::apps
