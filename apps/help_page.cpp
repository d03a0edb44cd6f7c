// SPDX-License-Identifier: GPL-3.0-or-later
#include "help_page.hpp"

#include <algorithm>
#include <sstream>

#include "roomatlas/core/counted.hpp"

namespace roomatlas::apps {
namespace {

constexpr std::size_t kWidth = 80;
constexpr std::size_t kColumn = 26;  // of the meanings

/// A text broken between words, from a column on; the first line begins there already.
std::string wrapped(const std::string& text, std::size_t column) {
  std::string lines;
  std::size_t at = column;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const bool is_first = at == column;
    if (!is_first && at + 1 + word.size() > kWidth) {
      lines += "\n" + std::string(column, ' ');
      at = column;
    } else if (!is_first) {
      lines += ' ';
      ++at;
    }
    lines += word;
    at += word.size();
  }
  return lines;
}

std::string entry(const std::string& name, const std::string& meaning) {
  constexpr std::size_t kIndent = 2;
  std::string text = std::string(kIndent, ' ') + name;
  if (text.size() + 2 > kColumn) {
    text += "\n" + std::string(kColumn, ' ');
  } else {
    text += std::string(kColumn - text.size(), ' ');
  }
  return text + wrapped(meaning, kColumn) + "\n";
}

std::string joined(const std::vector<std::string>& words, const char* sign) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : sign) + word;
  return text;
}

/// On a page the short name and the first long one, else all.
std::string left_column_of(const OptionText& option, HelpSize size) {
  std::vector<std::string> names = option.spoken_names();
  if (size == HelpSize::page && !option.is_place) {
    const auto first_long = std::find_if(
        names.begin(), names.end(), [](const std::string& name) { return name.starts_with("--"); });
    if (first_long != names.end()) names.erase(std::next(first_long), names.end());
  }
  std::string text = joined(names, ", ");
  if (option.is_place) return text + (option.is_repeated ? "..." : "");
  return option.value.empty() ? text : text + " " + option.value;
}

std::string meaning_of(const OptionText& option, HelpSize size) {
  std::string text = option.meaning;
  if (option.kind == ValueKind::choice) text += " {" + joined(option.choices, ", ") + "}";
  if (size == HelpSize::all && !option.range.empty()) text += "; " + option.range;
  if (!option.preset.empty() && option.group != "Options") text += " [" + option.preset + "]";
  if (option.is_required && !option.is_place) text += " (required)";
  return text;
}

std::string entries(const std::vector<OptionText>& options, HelpSize size) {
  std::string text;
  for (const OptionText& option : options) {
    text += entry(left_column_of(option, size), meaning_of(option, size));
  }
  return text;
}

/// A page has what is most often wanted: options without heading, and files of results.
bool is_for_page(const OptionGroup& group) {
  return group.heading.empty() || group.heading == kResults;
}

std::size_t count_of(const std::vector<OptionGroup>& groups) {
  std::size_t count = 0;
  for (const OptionGroup& group : groups) count += group.options.size();
  return count;
}

std::string groups_text(const std::vector<OptionGroup>& groups, HelpSize size) {
  std::string text;
  for (const OptionGroup& group : groups) {
    if (size == HelpSize::page && !is_for_page(group)) continue;
    text += "\n" + (group.heading.empty() ? std::string("Options") : group.heading) + ":\n";
    text += entries(group.options, size);
  }
  return text;
}

/// What `--help-all` has beside the page.
std::string rest_of(const CommandText& command) {
  std::size_t more = count_of(command.parameters);
  for (const OptionGroup& group : command.own) {
    if (!is_for_page(group)) more += group.options.size();
  }
  if (more == 0) return "";
  return wrapped("`roomatlas " + command.name + " --help-all` shows " +
                     counted(more, "more option") +
                     " and parameters, all of which have sound defaults.",
                 0) +
         "\n";
}

std::string list_of_commands(const ProgramText& program) {
  std::vector<std::string> groups;
  for (const CommandText& command : program.commands) {
    const std::string& group = command.notes.group;
    const bool is_new = std::find(groups.begin(), groups.end(), group) == groups.end();
    if (is_new && !group.empty()) groups.push_back(group);
  }
  std::string text;
  for (const std::string& group : groups) {
    text += "\n" + group + ":\n";
    for (const CommandText& command : program.commands) {
      constexpr std::size_t kNames = 12;
      if (command.notes.group != group) continue;
      text += "  " + command.name + std::string(kNames - 2 - command.name.size(), ' ') +
              wrapped(command.meaning, kNames) + "\n";
    }
  }
  return text;
}

}  // namespace

std::string help_of(const ProgramText& program, HelpSize size) {
  std::string text = wrapped(program.meaning, 0) + "\n\nUsage: " + program.name +
                     " COMMAND [OPTIONS] ...\n" + list_of_commands(program) +
                     "\nOptions of every command:\n" + entries(program.common, size);
  if (size == HelpSize::all) return text + groups_text(program.parameters, size);
  return text + "\nA first plan:  roomatlas build LOG -o OUT\n" +
         "Of a command:  roomatlas COMMAND --help\n";
}

std::string help_of(const CommandText& command, HelpSize size) {
  std::string text = wrapped(command.meaning, 0) + "\n\nUsage: " + wrapped(command.usage, 7) + "\n";
  if (!command.places.empty()) text += "\n" + entries(command.places, size);
  text += groups_text(command.own, size);
  if (size == HelpSize::all) text += groups_text(command.parameters, size);
  if (!command.notes.examples.empty()) text += "\nExamples:\n";
  for (const Example& example : command.notes.examples) {
    text += "  " + example.line + "\n      " + wrapped(example.meaning, 6) + "\n";
  }
  text += "\nOf every command: --json, -q, -v, --config FILE; see `roomatlas --help`.\n";
  return size == HelpSize::page ? text + rest_of(command) : text;
}

}  // namespace roomatlas::apps
