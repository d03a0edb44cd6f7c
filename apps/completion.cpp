// SPDX-License-Identifier: GPL-3.0-or-later
#include "completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <set>
#include <stdexcept>

namespace roomatlas::apps {
namespace {

using Options = std::vector<OptionText>;
using Names = std::vector<std::string>;

/// Everything with a name that may stand behind a command, in the order of the help.
Options options_of(const CommandText& command) {
  Options options;
  for (const std::vector<OptionGroup>* groups : {&command.own, &command.parameters}) {
    for (const OptionGroup& group : *groups) {
      options.insert(options.end(), group.options.begin(), group.options.end());
    }
  }
  return options;
}

Names names_of(const Options& options) {
  Names names;
  for (const OptionText& option : options) {
    for (const std::string& name : option.spoken_names()) names.push_back(name);
  }
  return names;
}

/// What the shells complete in the place of a command's first argument.
Names place_choices(const CommandText& command) {
  return command.places.empty() ? Names() : command.places.front().choices;
}

Names names_of_commands(const ProgramText& program) {
  Names names;
  for (const CommandText& command : program.commands) names.push_back(command.name);
  return names;
}

bool is_offered(const CommandText& command) { return !command.notes.group.empty(); }

/// Between single quotes: shells read nothing there but the quote's end.
std::string quoted(const std::string& text) {
  std::string quote = "'";
  for (const char c : text) quote += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quote + "'";
}

/// The meaning as far as it is short: the shells show it beside the name.
std::string short_meaning(const OptionText& option) {
  const std::string& all = option.meaning;
  constexpr std::size_t kLongest = 60;
  if (all.size() <= kLongest) return all;
  const std::size_t end = all.rfind(' ', kLongest);
  return all.substr(0, end) + " ...";
}

/// `case` branches of bash that say what stands behind the options of one kind.
std::string bash_values(const Options& options) {
  std::map<std::string, Names> by_answer;
  for (const OptionText& option : options) {
    std::string answer;
    switch (option.kind) {
      case ValueKind::none:
        continue;
      case ValueKind::file:
        answer = "_roomatlas_files -f";
        break;
      case ValueKind::folder:
        answer = "_roomatlas_files -d";
        break;
      case ValueKind::choice:
        answer = fmt::format("_roomatlas_words {}",
                             quoted(fmt::format("{}", fmt::join(option.choices, " "))));
        break;
      case ValueKind::other:
        answer = ":";
        break;
    }
    for (const std::string& name : option.names) by_answer[answer].push_back(name);
  }
  std::string text;
  for (const auto& [answer, names] : by_answer) {
    text += fmt::format("        {})\n          {}\n          return\n          ;;\n",
                        fmt::join(names, "|"), answer);
  }
  return text;
}

std::string bash_command(const CommandText& command, const Options& common) {
  Options options = options_of(command);
  options.insert(options.end(), common.begin(), common.end());
  const Names choices = place_choices(command);
  const std::string places =
      command.places.empty() ? ":"
      : choices.empty()
          ? "_roomatlas_files -f"
          : fmt::format("_roomatlas_words {}", quoted(fmt::format("{}", fmt::join(choices, " "))));
  return fmt::format(
      "    {})\n      case \"$before\" in\n{}      esac\n      if [[ $now == -* ]]; then\n"
      "        _roomatlas_words {}\n      else\n        {}\n      fi\n      ;;\n",
      command.name, bash_values(options),
      quoted(fmt::format("{}", fmt::join(names_of(options), " "))), places);
}

std::string bash(const ProgramText& program) {
  Names offered;
  std::string commands;
  for (const CommandText& command : program.commands) {
    commands += bash_command(command, program.common);
    if (is_offered(command)) offered.push_back(command.name);
  }
  return fmt::format(
      R"(# bash completion of roomatlas, made by `roomatlas completion bash`
_roomatlas_words() {{
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$now")
}}

_roomatlas_files() {{
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen "$1" -- "$now")
}}

_roomatlas() {{
  local now=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} command= word
  COMPREPLY=()
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    case "$word" in
      {})
        command=$word
        break
        ;;
    esac
  done
  case "$command" in
{}    *)
      case "$before" in
{}      esac
      if [[ $now == -* ]]; then
        _roomatlas_words {}
      else
        _roomatlas_words {}
      fi
      ;;
  esac
}}

complete -F _roomatlas roomatlas
)",
      fmt::join(names_of_commands(program), "|"), commands, bash_values(program.common),
      quoted(fmt::format("{}", fmt::join(names_of(program.common), " "))),
      quoted(fmt::format("{}", fmt::join(offered, " "))));
}

/// Text in an _arguments specification, where a few signs have a meaning.
std::string zsh_text(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') safe += '\\';
    safe += c;
  }
  return safe;
}

std::string zsh_value(const OptionText& option) {
  switch (option.kind) {
    case ValueKind::none:
      return "";
    case ValueKind::file:
      return ":file:_files";
    case ValueKind::folder:
      return ":folder:_files -/";
    case ValueKind::choice:
      return fmt::format(":choice:({})", fmt::join(option.choices, " "));
    case ValueKind::other:
      return ":" + zsh_text(option.value) + ": ";
  }
  return "";
}

std::string zsh_specs(const Options& options) {
  std::string text;
  for (const OptionText& option : options) {
    for (const std::string& name : option.spoken_names()) {
      text += " \\\n        " + quoted((option.is_repeated ? "*" : "") + name + "[" +
                                       zsh_text(short_meaning(option)) + "]" + zsh_value(option));
    }
  }
  return text;
}

std::string zsh_places(const CommandText& command) {
  std::string text;
  for (const OptionText& place : command.places) {
    const std::string what = zsh_text(place.names.front());
    const std::string value = place.kind == ValueKind::file ? "_files"
                              : place.kind == ValueKind::choice
                                  ? fmt::format("({})", fmt::join(place.choices, " "))
                                  : " ";
    text += " \\\n        " + quoted((place.is_repeated ? "*:" : ":") + what + ":" + value);
  }
  return text;
}

std::string zsh(const ProgramText& program) {
  std::string list;
  std::string cases;
  for (const CommandText& command : program.commands) {
    if (is_offered(command)) {
      list += "\n        " + quoted(zsh_text(command.name) + ":" + command.meaning);
    }
    cases +=
        fmt::format("        {})\n      _arguments -s{}{}{}\n          ;;\n", command.name,
                    zsh_specs(options_of(command)), zsh_specs(program.common), zsh_places(command));
  }
  return fmt::format(
      R"(#compdef roomatlas
# zsh completion of roomatlas, made by `roomatlas completion zsh`
_roomatlas() {{
  local context state state_descr line
  typeset -A opt_args
  _arguments -C -s{} \
    '1:command:->command' '*::argument:->argument'
  case $state in
    command)
      local -a commands
      commands=({}
      )
      _describe command commands
      ;;
    argument)
      case $line[1] in
{}      esac
      ;;
  esac
}}

if [[ $funcstack[1] == _roomatlas ]]; then
  _roomatlas "$@"
else
  compdef _roomatlas roomatlas
fi
)",
      zsh_specs(program.common), list, cases);
}

std::string fish_option(const OptionText& option, const std::string& when) {
  std::string text;
  for (const std::string& name : option.spoken_names()) {
    const bool is_long = name.starts_with("--");
    text += "complete -c roomatlas -n " + quoted(when) + (is_long ? " -l " : " -s ") +
            name.substr(is_long ? 2 : 1);
    if (option.kind == ValueKind::file) text += " -r -F";
    if (option.kind == ValueKind::folder) text += " -x -a '(__fish_complete_directories)'";
    if (option.kind == ValueKind::other) text += " -x";
    if (option.kind == ValueKind::choice) {
      text += " -x -a " + quoted(fmt::format("{}", fmt::join(option.choices, " ")));
    }
    text += " -d " + quoted(short_meaning(option)) + "\n";
  }
  return text;
}

std::string fish(const ProgramText& program) {
  const std::string all = fmt::format("{}", fmt::join(names_of_commands(program), " "));
  const std::string none = "not __fish_seen_subcommand_from " + all;
  std::string text =
      "# fish completion of roomatlas, made by `roomatlas completion fish`\n"
      "complete -c roomatlas -f -n " +
      quoted(none) + "\n";
  for (const CommandText& command : program.commands) {
    if (is_offered(command)) {
      text += "complete -c roomatlas -n " + quoted(none) + " -a " + command.name + " -d " +
              quoted(command.meaning) + "\n";
    }
    const std::string in = "__fish_seen_subcommand_from " + command.name;
    for (const OptionText& option : options_of(command)) text += fish_option(option, in);
    const Names choices = place_choices(command);
    if (choices.empty()) continue;
    text += "complete -c roomatlas -f -n " + quoted(in) + " -a " +
            quoted(fmt::format("{}", fmt::join(choices, " "))) + "\n";
  }
  for (const OptionText& option : program.common) text += fish_option(option, "true");
  return text;
}

}  // namespace

Names completion_shells() { return {"bash", "zsh", "fish"}; }

std::string completion(const ProgramText& program, const std::string& shell) {
  if (shell == "bash") return bash(program);
  if (shell == "zsh") return zsh(program);
  if (shell == "fish") return fish(program);
  throw std::invalid_argument("no completion for " + shell);
}

}  // namespace roomatlas::apps
