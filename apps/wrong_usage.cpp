// SPDX-License-Identifier: GPL-3.0-or-later
// One of the files that include CLI11.
#include "wrong_usage.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>

#include "command_tree.hpp"
#include "did_you_mean.hpp"
#include "help_page.hpp"

namespace roomatlas::apps {
namespace {

using Names = std::vector<std::string>;

bool is_option(const std::string& word) { return word.size() > 1 && word.front() == '-'; }

void add_names(const std::vector<OptionText>& options, Names& names) {
  for (const OptionText& option : options) {
    for (const std::string& name : option.spoken_names()) {
      if (name.starts_with("--")) names.push_back(name);
    }
  }
}

Names own_names(const CommandText& command) {
  Names names;
  for (const OptionGroup& group : command.own) add_names(group.options, names);
  return names;
}

/// Commands that have an option which this one has not.
Names owners_of(const std::string& option, const ProgramText& program) {
  Names owners;
  for (const CommandText& command : program.commands) {
    const Names names = own_names(command);
    const bool has = std::find(names.begin(), names.end(), option) != names.end();
    if (has && !command.notes.group.empty()) owners.push_back("`" + command.name + "`");
  }
  return owners;
}

std::string of_option(const std::string& word, const CommandText* command,
                      const ProgramText& program) {
  const std::string option = word.substr(0, word.find('='));
  const std::string who = command != nullptr ? "`" + command->name + "`" : "roomatlas";
  const Names owners = owners_of(option, program);
  if (!owners.empty()) {
    return fmt::format("{} has no option {}: it belongs to {}", who, option,
                       fmt::join(owners, ", "));
  }
  Names names = command != nullptr ? own_names(*command) : Names();
  add_names(program.common, names);
  for (const OptionGroup& group : program.parameters) add_names(group.options, names);
  return fmt::format("{} has no option {}{}", who, option, did_you_mean(option, names));
}

std::string of_command(const std::string& word, const ProgramText& program) {
  Names names;
  for (const CommandText& command : program.commands) names.push_back(command.name);
  std::error_code unreadable;
  if (std::filesystem::exists(word, unreadable)) {
    return fmt::format("{} is no command but a file: `roomatlas build {} -o OUT` makes its plan",
                       word, word);
  }
  return fmt::format("there is no command \"{}\"{}", word, did_you_mean(word, names));
}

std::string of_extra(const std::string& word, const CommandText& command) {
  return fmt::format("`{}` does not know what to do with \"{}\"\nusage: {}", command.name, word,
                     command.usage);
}

/// An option that takes one of a few names and was given another.
std::string of_choice(const CLI::App& app, const std::vector<OptionText>& options) {
  for (const OptionText& option : options) {
    if (option.choices.empty()) continue;
    const CLI::Option* given = app.get_option_no_throw(option.names.back());
    if (given == nullptr) continue;
    for (const std::string& word : given->results()) {
      const Names& known = option.choices;
      if (std::find(known.begin(), known.end(), word) != known.end()) continue;
      return fmt::format("{}: expected one of {}, found \"{}\"{}", option.names.back(),
                         fmt::join(known, ", "), word, did_you_mean(word, known));
    }
  }
  return "";
}

std::string of_choice(const CLI::App& app, const CLI::App* chosen, const ProgramText& program) {
  std::string text;
  if (chosen != nullptr) {
    const CommandText& command = program.command(chosen->get_name());
    for (const OptionGroup& group : command.own) {
      if (text.empty()) text = of_choice(*chosen, group.options);
    }
    if (text.empty()) text = of_choice(*chosen, command.places);
  }
  for (const OptionGroup& group : program.parameters) {
    if (text.empty()) text = of_choice(app, group.options);
  }
  return text;
}

std::string reason(const CLI::App& app, const CLI::App* chosen, const ProgramText& program,
                   const CLI::ParseError& error) {
  const CommandText* command = chosen != nullptr ? &program.command(chosen->get_name()) : nullptr;
  const Names rest = app.remaining(true);
  const auto option = std::find_if(rest.begin(), rest.end(), is_option);
  if (option != rest.end()) return of_option(*option, command, program);
  if (command == nullptr && !rest.empty()) return of_command(rest.front(), program);
  if (dynamic_cast<const CLI::ValidationError*>(&error) != nullptr ||
      dynamic_cast<const CLI::ConversionError*>(&error) != nullptr) {
    const std::string text = of_choice(app, chosen, program);
    if (!text.empty()) return text;
  }
  if (command != nullptr && !rest.empty()) return of_extra(rest.front(), *command);
  const std::string usage =
      command != nullptr && dynamic_cast<const CLI::RequiredError*>(&error) != nullptr
          ? "\nusage: " + command->usage
          : "";
  return error.what() + usage;
}

}  // namespace

std::string explain(const CLI::App& app, const CLI::ParseError& error) {
  const ProgramText program = text_of(app);
  const std::vector<CLI::App*> subcommands = const_cast<CLI::App&>(app).get_subcommands();
  const CLI::App* chosen = subcommands.empty() ? nullptr : subcommands.front();
  if (chosen == nullptr && app.remaining(true).empty() &&
      dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
    return help_of(program, HelpSize::page);
  }
  return fmt::format("error: {}\nrun `roomatlas{} --help`\n", reason(app, chosen, program, error),
                     chosen != nullptr ? " " + chosen->get_name() : "");
}

}  // namespace roomatlas::apps
