// SPDX-License-Identifier: GPL-3.0-or-later
#include "man_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "did_you_mean.hpp"
#include "output_places.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/files/files.hpp"

namespace roomatlas::apps {
namespace {

/// A text that roff shows as it is: no line of it is a request, and a minus can be copied.
std::string escaped(const std::string& text) {
  std::string roff;
  for (const char c : text) {
    if (c == '\\') {
      roff += "\\e";
    } else if (c == '-') {
      roff += "\\-";
    } else if (c == '~') {
      roff += "\\(ti";
    } else if (c == '^') {
      roff += "\\(ha";
    } else if (c == '`') {
      roff += "\\(ga";
    } else {
      roff += c;
    }
  }
  return roff.starts_with('.') || roff.starts_with('\'') ? "\\&" + roff : roff;
}

std::string section(const std::string& name) { return ".SH " + name + "\n"; }

std::string bold(const std::string& text) { return "\\fB" + escaped(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + escaped(text) + "\\fR"; }

std::string paragraph(const std::string& text) { return ".PP\n" + escaped(text) + "\n"; }

std::string head(const std::string& name, const std::string& meaning) {
  std::string title = name;
  std::transform(title.begin(), title.end(), title.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  // The date would change with every build: a page says its release instead.
  return ".\\\" Made by `roomatlas man`; SPDX-License-Identifier: GPL-3.0-or-later\n.TH " +
         escaped(title) + " 1 \"\" \"Roomatlas " + ROOMATLAS_VERSION + "\" \"Roomatlas\"\n" +
         section("NAME") + escaped(name) + " \\- " + escaped(meaning) + "\n";
}

std::string term(const OptionText& option) {
  std::string text;
  for (const std::string& name : option.is_place ? option.names : option.spoken_names()) {
    text += (text.empty() ? "" : ", ") + (option.is_place ? italic(name) : bold(name));
  }
  if (option.is_place) return text + (option.is_repeated ? " ..." : "");
  return option.value.empty() ? text : text + " " + italic(option.value);
}

std::string sentence_of(const OptionText& option) {
  std::string text = option.meaning;
  if (option.kind == ValueKind::choice) {
    text += fmt::format(". One of {}", fmt::join(option.choices, ", "));
  }
  if (!option.range.empty()) text += ". From " + option.range;
  if (!option.preset.empty() && option.group != "Options") text += ". Default: " + option.preset;
  if (option.is_required) text += ". Required";
  return text + ".";
}

std::string list_of(const std::vector<OptionText>& options) {
  std::string text;
  for (const OptionText& option : options) {
    text += ".TP\n" + term(option) + "\n" + escaped(sentence_of(option)) + "\n";
  }
  return text;
}

std::string groups_of(const std::vector<OptionGroup>& groups) {
  std::string text;
  for (const OptionGroup& group : groups) {
    if (!group.heading.empty()) text += ".SS \"" + escaped(group.heading) + "\"\n";
    text += list_of(group.options);
  }
  return text;
}

std::string examples_of(const std::vector<Example>& examples) {
  if (examples.empty()) return "";
  std::string text = section("EXAMPLES");
  for (const Example& example : examples) {
    text += ".TP\n" + bold(example.line) + "\n" + escaped(example.meaning) + "\n";
  }
  return text;
}

std::string exit_status() {
  std::string text = section("EXIT STATUS");
  const auto add = [&](const char* code, const char* meaning) {
    text += std::string(".TP\n") + code + "\n" + escaped(meaning) + "\n";
  };
  add("0", "All went well.");
  add("1", "An error of the program itself: please report it.");
  add("2", "The command line or the configuration file is wrong.");
  add("3", "An input cannot be read, or an output cannot be written.");
  add("4", "What was read is not enough for a result.");
  add("5", "A result was written, and with --strict its quality is not enough.");
  add("130", "Interrupted, by Ctrl-C or SIGTERM.");
  return text;
}

std::string usage_of(const CommandText& command) {
  std::string usage = bold("roomatlas " + command.name);
  return usage + " " + escaped(command.usage.substr(("roomatlas " + command.name + " ").size()));
}

}  // namespace

std::string man_page(const ProgramText& program) {
  std::string text = head(program.name, "building maps from robot missions");
  text += section("SYNOPSIS") + bold(program.name) + " " + italic("COMMAND") + " [OPTIONS] ...\n";
  text += section("DESCRIPTION") + escaped(program.meaning) + ".\n";
  text += paragraph(
      "Each command has a page of its own, such as roomatlas-build(1). Results go to stdout, "
      "messages and progress to stderr.");
  text += section("COMMANDS");
  for (const CommandText& command : program.commands) {
    text += ".TP\n" + bold(command.name) + "\n" + escaped(command.meaning) + ".\n";
  }
  text += section("OPTIONS") + list_of(program.common);
  text += section("PARAMETERS") +
          escaped(
              "Parameters of the stages; commands that do not run a stage make nothing of its "
              "parameters. In a configuration file they stand without the two minus signs.") +
          "\n" + groups_of(program.parameters);
  text += section("CONFIGURATION FILE") +
          escaped(
              "TOML, name = value, a parameter a line and no sections. `roomatlas config --print` "
              "writes one with all parameters, their defaults and meanings; --config FILE reads "
              "it. What stands on the command line wins.") +
          "\n";
  text += exit_status();
  text += section("SEE ALSO");
  std::string pages;
  for (const CommandText& command : program.commands) {
    pages +=
        (pages.empty() ? "" : ",\n") + (".BR " + escaped("roomatlas-" + command.name) + " (1)");
  }
  return text + pages + "\n";
}

std::string man_page_alone(const ProgramText& program, const std::string& usage) {
  std::string text = head(program.name, program.meaning);
  text += section("SYNOPSIS") + bold(program.name) + " " + escaped(usage) + "\n";
  text += section("DESCRIPTION") + escaped(program.meaning) + ".\n";
  text += section("OPTIONS") + list_of(program.common);
  text += section("PARAMETERS") + groups_of(program.parameters);
  return text + exit_status() + section("SEE ALSO") + ".BR roomatlas (1),\n.BR mpirun (1)\n";
}

std::string man_page(const ProgramText& program, const CommandText& command) {
  std::string text = head("roomatlas-" + command.name, command.meaning);
  text += section("SYNOPSIS") + usage_of(command) + "\n";
  text += section("DESCRIPTION") + escaped(command.meaning) + ".\n";
  text += section("OPTIONS") + list_of(command.places) + groups_of(command.own);
  text += ".SS \"Of every command\"\n" + list_of(program.common);
  if (!command.parameters.empty()) text += section("PARAMETERS") + groups_of(command.parameters);
  text += examples_of(command.notes.examples) + exit_status();
  return text + section("SEE ALSO") + ".BR roomatlas (1)\n";
}

void man(const ProgramText& program, const ManArguments& arguments) {
  if (arguments.out.empty()) {
    if (arguments.command.empty()) {
      fmt::print("{}", man_page(program));
      return;
    }
    std::vector<std::string> names;
    for (const CommandText& command : program.commands) {
      if (command.name == arguments.command) {
        fmt::print("{}", man_page(program, command));
        return;
      }
      names.push_back(command.name);
    }
    throw UsageError("man: there is no command \"" + arguments.command + "\"" +
                     did_you_mean(arguments.command, names));
  }
  make_folder(arguments.out);
  write_file(arguments.out / (program.name + ".1"), man_page(program));
  for (const CommandText& command : program.commands) {
    write_file(arguments.out / (program.name + "-" + command.name + ".1"),
               man_page(program, command));
  }
}

}  // namespace roomatlas::apps
