// SPDX-License-Identifier: GPL-3.0-or-later
// One of the files that include CLI11.
#include "command_tree.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace roomatlas::apps {
namespace {

/// What stands between two signs; empty where they are not there.
std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t start = text.find(from);
  if (start == std::string::npos) return "";
  const std::size_t end = text.find(to, start + from.size());
  if (end == std::string::npos) return "";
  return text.substr(start + from.size(), end - start - from.size());
}

/// The names in "{a,b}" or "value in {a->1,b->2} OR {1,2}".
std::vector<std::string> choices_in(const std::string& check) {
  std::vector<std::string> choices;
  for (const std::string& entry : CLI::detail::split(between(check, "{", "}"), ',')) {
    const std::string name = entry.substr(0, entry.find("->"));
    if (!name.empty()) choices.push_back(name);
  }
  return choices;
}

/// "0.02 to 1" of "FLOAT in [0.02 - 1]".
std::string range_in(const std::string& check) {
  std::string range = between(check, " in [", "]");
  const std::size_t sign = range.find(" - ");
  if (sign != std::string::npos) range.replace(sign, 3, " to ");
  return range;
}

void add_value(const CLI::Option& option, OptionText& text) {
  const std::string type = option.get_type_name();
  text.value = type.substr(0, type.find(':'));
  const std::string check = type.substr(text.value.size());
  text.choices = choices_in(check);
  text.range = range_in(check);
  text.kind = ValueKind::other;
  if (text.value == "FILE") text.kind = ValueKind::file;
  if (text.value == "FOLDER") text.kind = ValueKind::folder;
  if (!text.choices.empty()) {
    text.kind = ValueKind::choice;
    text.value = "CHOICE";
  }
  if (std::set<std::string>{"FLOAT", "INT", "UINT"}.contains(text.value)) text.value = "NUMBER";
}

OptionText text_of(const CLI::Option& option) {
  OptionText text;
  for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  text.is_place = option.get_positional();
  if (text.is_place) text.names = {option.get_name(true)};
  text.group = option.get_group();
  text.meaning = option.get_description();
  const bool is_flag = option.get_items_expected_max() == 0;
  if (!is_flag) add_value(option, text);
  text.preset = option.get_default_str();
  text.is_required = option.get_required();
  text.is_repeated = option.get_expected_max() > option.get_expected_min() &&
                     option.get_expected_max() >= CLI::detail::expected_max_vector_size;
  return text;
}

OptionGroup& group_of(std::vector<OptionGroup>& groups, const std::string& heading) {
  const auto found = std::find_if(groups.begin(), groups.end(), [&](const OptionGroup& group) {
    return group.heading == heading;
  });
  if (found != groups.end()) return *found;
  return groups.emplace_back(OptionGroup{heading, {}});
}

bool is_help(const CLI::App& app, const CLI::Option* option) {
  return option == app.get_help_ptr() || option == app.get_help_all_ptr();
}

std::string usage_of(const CommandText& command) {
  std::string usage = "roomatlas " + command.name + " [OPTIONS]";
  for (const OptionText& place : command.places) {
    const std::string name = place.names.front() + (place.is_repeated ? "..." : "");
    usage += place.is_required ? " " + name : " [" + name + "]";
  }
  for (const OptionGroup& group : command.own) {
    for (const OptionText& option : group.options) {
      if (option.is_required) usage += " " + option.names.front() + " " + option.value;
    }
  }
  return usage;
}

CommandText text_of(const CLI::App& app, const ProgramText& program) {
  CommandText text;
  text.name = app.get_name();
  text.meaning = app.get_description();
  text.notes = notes_of(text.name);
  for (const CLI::Option* option : app.get_options()) {
    if (is_help(app, option)) continue;
    OptionText one = text_of(*option);
    if (one.is_place) {
      text.places.push_back(std::move(one));
    } else {
      group_of(text.own, one.group == "Options" ? "" : one.group).options.push_back(std::move(one));
    }
  }
  for (const Stage stage : text.notes.stages) {
    for (const OptionGroup& group : program.parameters) {
      if (group.heading == heading_of(stage)) text.parameters.push_back(group);
    }
  }
  text.usage = usage_of(text);
  return text;
}

}  // namespace

std::vector<std::string> OptionText::spoken_names() const {
  std::vector<std::string> spoken;
  std::copy_if(names.begin(), names.end(), std::back_inserter(spoken),
               [](const std::string& name) { return name.find('_') == std::string::npos; });
  return spoken;
}

const CommandText& ProgramText::command(const std::string& wanted) const {
  for (const CommandText& command : commands) {
    if (command.name == wanted) return command;
  }
  throw std::logic_error("no command " + wanted);
}

ProgramText text_of(const CLI::App& app) {
  ProgramText text;
  text.name = app.get_name();
  text.meaning = app.get_description();
  for (const CLI::Option* option : app.get_options()) {
    OptionText one = text_of(*option);
    if (one.group == "Options") {
      text.common.push_back(std::move(one));
    } else {
      group_of(text.parameters, one.group).options.push_back(std::move(one));
    }
  }
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    text.commands.push_back(text_of(*command, text));
  }
  return text;
}

}  // namespace roomatlas::apps
