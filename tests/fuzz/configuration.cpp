// SPDX-License-Identifier: GPL-3.0-or-later
// Configurations: the file of --config, and what a store keeps of the parameters it was made with.
#include <CLI/CLI.hpp>

#include <memory>
#include <sstream>

#include "bind_parameters.hpp"
#include "roomatlas/core/issue.hpp"
#include "target.hpp"

namespace roomatlas::fuzz {
namespace {

/// With all parameters, once for all inputs: their file has one name.
CLI::App& app_with(const Path& file) {
  static apps::Settings settings;
  static const auto app = [&] {
    auto made = std::make_unique<CLI::App>();
    apps::bind_parameters(*made, settings);
    made->set_config("--config", file.string());
    made->config_formatter(std::make_shared<apps::ConfigurationFile>(*made));
    return made;
  }();
  return *app;
}

void read_file(const Path& file, const std::string&) {
  try {
    app_with(file).parse(std::string());
  } catch (const CLI::ParseError& wrong) {
    throw UsageError(wrong.what());
  }
}

void read_stored(const Path&, const std::string& toml) {
  try {
    static const apps::Settings defaults = apps::default_settings();
    (void)apps::with_configuration(defaults, toml, [](const std::string&, auto) { return true; });
  } catch (const UsageError&) {  // the store's name is said by who reads it
  }
}

/// All parameters, some of them at a time: an input takes time for each.
std::vector<std::string> defaults() {
  std::istringstream toml(apps::default_settings().as_toml);
  std::vector<std::string> parts;
  int count = 0;
  for (std::string line; std::getline(toml, line); ++count) {
    if (count % 8 == 0) parts.emplace_back();
    parts.back() += line + '\n';
  }
  return parts;
}

std::vector<std::string> seeds() {
  std::vector<std::string> seeds = {
      "# comment\ncell=0.1\nheading-bias=true\nsonar-cone = 30\n", "max-piece=8\njobs=1\n",
      "cell=[0.1, 0.2]\n[section]\nlaser-max=\"50\"\nscan-topics='/a,/b'\n"};
  for (const std::string& part : defaults()) seeds.push_back(part);
  return seeds;
}

}  // namespace

std::vector<Target> configuration_targets() {
  return {{"configuration", "settings.toml", seeds, read_file},
          {"stored_configuration", "stored.toml", seeds, read_stored}};
}

}  // namespace roomatlas::fuzz
