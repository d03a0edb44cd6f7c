// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include "did_you_mean.hpp"
#include "limits.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/core/pose2.hpp"

namespace roomatlas::apps {
namespace {

// One parameter of each kind:

CLI::Option* bind(CLI::App& app, const Parameter& parameter, const NumberParameter& number) {
  return std::visit(
      [&](auto* value) {
        return app.add_option("--" + parameter.name, *value, parameter.meaning)
            ->capture_default_str()
            ->check(within(number.low, number.high));
      },
      number.value);
}
CLI::Option* bind(CLI::App& app, const Parameter& parameter, const DegreesParameter& angle) {
  std::ostringstream now_deg;  // as the others' defaults are written
  now_deg << degrees(*angle.value_rad);
  const auto keep = [value_rad = angle.value_rad](double value_deg) {
    *value_rad = radians(value_deg);
  };
  return app.add_option_function<double>("--" + parameter.name, keep, parameter.meaning)
      ->default_str(now_deg.str())
      ->check(within(angle.low_deg, angle.high_deg));
}
CLI::Option* bind(CLI::App& app, const Parameter& parameter, const FlagParameter& flag) {
  const std::string& name = parameter.name;
  return app.add_flag("--" + name + ",!--no-" + name, *flag.value, parameter.meaning)
      ->default_str(*flag.value ? "true" : "false");
}
CLI::Option* bind(CLI::App& app, const Parameter& parameter, const ChoiceParameter& choice) {
  return app
      .add_option_function<std::string>("--" + parameter.name, choice.choose, parameter.meaning)
      ->default_str(choice.now)
      ->check(CLI::IsMember(choice.names));
}
CLI::Option* bind(CLI::App& app, const Parameter& parameter, const TextParameter& text) {
  return app.add_option("--" + parameter.name, *text.value, parameter.meaning)
      ->join(',')
      ->capture_default_str();
}
CLI::Option* bind(CLI::App& app, const Parameter& parameter, const FileParameter& file) {
  return app.add_option("--" + parameter.name, *file.value, parameter.meaning)
      ->type_name("FILE")
      ->configurable(false);  // no path gets into the store
}

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr const char* kTwice = " is given twice";

bool is_text(const std::string& line) {
  return std::none_of(line.begin(), line.end(),
                      [](unsigned char c) { return c < 32 && c != '\t'; });
}

/// Names are plain letters, so that the message can show them.
bool is_plain(const std::string& name) {
  return std::all_of(name.begin(), name.end(), [](unsigned char c) { return c >= 32 && c < 127; });
}

/// The parameter that a line names.
std::string name_in(const std::string& line) {
  const std::size_t sign = line.find('=');
  std::string name = CLI::detail::trim_copy(line.substr(0, sign));
  if (!is_text(line) || !is_plain(name)) {
    throw UsageError("is no text of parameters: expected lines of name = value");
  }
  if (line.front() == '[') throw UsageError("sections are not used: " + name);
  if (sign == std::string::npos || name.empty()) {
    throw UsageError("expected name = value, found \"" + line + "\"");
  }
  return CLI::detail::remove_quotes(name);
}

void bind(CLI::App& app, const Parameter& parameter) {
  CLI::Option* option =
      std::visit([&](const auto& kind) { return bind(app, parameter, kind); }, parameter.kind)
          ->group(heading_of(parameter.stage));
  if (parameter.stage == Stage::run) option->configurable(false);
}

/// CLI11 splits such a value into none, and then reads the first of them.
bool is_only_commas(const std::string& value) {
  return !value.empty() && value.find_first_not_of(',') == std::string::npos;
}

/// CLI11 looks for the end of such a list in the lines that follow, and takes them for its values.
void require_whole_lists(const std::string& lines) {
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) {
    const std::size_t sign = line.find('=');
    if (sign == std::string::npos) continue;
    const std::size_t comment = line.find('#', sign);
    const std::string value = CLI::detail::trim_copy(line.substr(sign + 1, comment - sign - 1));
    if (value.starts_with('[') && (value.size() < 2 || !value.ends_with(']'))) {
      throw UsageError(CLI::detail::trim_copy(line.substr(0, sign)) +
                       ": expected a value after =, found a list without an end, " + value);
    }
  }
}

/// Reads lines as the program would: into an app that has the parameters that they name.
void parse(CLI::App& app, const std::string& lines) {
  require_whole_lists(lines);
  std::istringstream in(lines);
  for (const CLI::ConfigItem& item : CLI::ConfigTOML().from_config(in)) {  // CLI11 reads the first
    const bool is_nothing = std::all_of(item.inputs.begin(), item.inputs.end(), is_only_commas);
    if (is_nothing) throw UsageError(item.name + ": expected a value after =");
  }
  in = std::istringstream(lines);
  try {
    app.parse_from_stream(in);
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
}

void try_line(const std::string& name, const std::string& line) {
  CLI::App app;
  Settings unused;
  const std::vector<Parameter> parameters = parameters_of(unused);
  for (const Parameter& parameter : parameters) {
    if (name == parameter.name || name == "no-" + parameter.name) bind(app, parameter);
  }
  if (app.get_option_no_throw("--" + name) == nullptr) {
    std::vector<std::string> names;
    names.reserve(parameters.size());
    for (const Parameter& parameter : parameters) names.push_back(parameter.name);
    throw UsageError("no such parameter: " + name + did_you_mean(name, names));
  }
  parse(app, line);
}

void check_line(const std::string& line, std::set<std::string>& names) {
  const std::string text = CLI::detail::trim_copy(line);
  if (text.empty() || text.front() == '#' || text.front() == ';') return;
  const std::string name = name_in(text);
  try_line(name, text);
  if (!names.insert(name).second) throw UsageError(name + kTwice);
}

void check(const std::string& content, const std::string& file) {
  std::istringstream in(content);
  std::set<std::string> names;
  std::int64_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    try {
      check_line(line, names);
    } catch (const UsageError& wrong) {
      throw UsageError(fmt::format("{}:{}: {}; `roomatlas config --print` shows all parameters",
                                   file, number, wrong.what()));
    }
  }
}

/// A line of a stored configuration, and the parameter that it names.
struct Line {
  std::string name;
  std::string text;
};

std::vector<Line> lines_of(const std::string& toml) {
  std::vector<Line> lines;
  std::istringstream in(toml);
  for (std::string text; std::getline(in, text);) {
    if (!text.empty()) lines.push_back({text.substr(0, text.find_first_of(" =")), text});
  }
  return lines;
}

/// A configuration with some of its lines, by their names, in the place of its own.
std::string with_lines(const std::string& toml, const std::map<std::string, std::string>& taken) {
  std::string result;
  for (const Line& line : lines_of(toml)) {
    const auto other = taken.find(line.name);
    result += other == taken.end() ? line.text : other->second;
    result += '\n';
  }
  return result;
}

}  // namespace

void bind_parameters(CLI::App& app, Settings& settings) {
  for (const Parameter& parameter : parameters_of(settings)) bind(app, parameter);
}

void complete(Settings& settings, const CLI::App& app) {
  share(settings);
  settings.as_toml = app.config_to_str(true, false);
  for (const CLI::Option* option : app.get_options()) {
    if (option->count() > 0) settings.given.insert(option->get_single_name());
  }
}

Settings default_settings() {
  Settings settings;
  CLI::App app;
  bind_parameters(app, settings);
  complete(settings, app);
  return settings;
}

FromConfiguration with_configuration(
    const Settings& settings, const std::string& toml,
    const std::function<bool(const std::string& name, Stage stage)>& takes) {
  FromConfiguration result{settings, {}};
  std::map<std::string, Parameter> parameter_of;
  for (const Parameter& parameter : parameters_of(result.settings)) {
    parameter_of.emplace(parameter.name, parameter);
  }
  CLI::App app;
  std::map<std::string, std::string> taken;
  for (const Line& line : lines_of(toml)) {
    const auto parameter = parameter_of.find(line.name);
    if (parameter == parameter_of.end()) {
      result.unknown.push_back(line.name);
    } else if (takes(line.name, parameter->second.stage)) {
      if (!taken.emplace(line.name, line.text).second) throw UsageError(line.name + kTwice);
      bind(app, parameter->second);
    }
  }
  std::string lines;
  for (const auto& entry : taken) lines += entry.second + '\n';
  parse(app, lines);
  share(result.settings);
  result.settings.as_toml = with_lines(settings.as_toml, taken);
  return result;
}

std::vector<CLI::ConfigItem> ConfigurationFile::from_config(std::istream& input) const {
  if (opening_) {
    for (auto& watch : *opening_) watch.second.reset();
  }
  std::string content(std::istreambuf_iterator<char>(input), {});
  if (content.starts_with(kByteOrderMark)) content.erase(0, kByteOrderMark.size());
  check(content, app_.get_config_ptr()->as<std::string>());
  std::istringstream checked(content);
  return CLI::ConfigTOML::from_config(checked);
}

void add_configuration_file(CLI::App& app) {
  const auto opening = std::make_shared<ConfigurationFile::Watches>();
  const auto watch = [opening](const std::string& file) -> std::string {
    try {
      if (!opening->contains(file)) (*opening)[file] = std::make_unique<PipeWatch>(file);
      return {};
    } catch (const InputError& error) {
      return error.what();
    }
  };
  app.set_config("--config", "", "read parameters from this file (TOML)")
      ->type_name("FILE")
      ->check(CLI::Validator(watch, ""))
      ->configurable(false);
  app.config_formatter(std::make_shared<ConfigurationFile>(app, opening));
}

}  // namespace roomatlas::apps
