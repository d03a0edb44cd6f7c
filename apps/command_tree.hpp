// SPDX-License-Identifier: GPL-3.0-or-later
// What the command line takes, as plain values: help, manual and completion are written from it,
// and it is read from what parses the command line. They cannot differ.
#pragma once

#include <string>
#include <vector>

#include "command_notes.hpp"

namespace CLI {
class App;
}

namespace roomatlas::apps {

/// What may follow an option, or stand in a place.
enum class ValueKind { none, file, folder, choice, other };

struct OptionText {
  std::vector<std::string> names;  ///< "-o", "--output"; of a place: "STORE" alone
  std::string group;               ///< heading of the help
  std::string meaning;
  ValueKind kind = ValueKind::none;
  std::string value;                 ///< "FILE", "X,Y,DEG" ...; empty for a flag
  std::vector<std::string> choices;  ///< all that it may be, of a choice
  std::string range;                 ///< "0.02 to 1"; empty where any number will do
  std::string preset;                ///< what holds where it is not given; empty: nothing does
  bool is_place = false;             ///< told by where it stands, without a name
  bool is_required = false;
  bool is_repeated = false;  ///< takes several

  /// The names for people: without those that differ in underscores alone.
  [[nodiscard]] std::vector<std::string> spoken_names() const;
};

/// Options below one heading.
struct OptionGroup {
  std::string heading;
  std::vector<OptionText> options;
};

struct CommandText {
  std::string name;
  std::string meaning;
  std::string usage;  ///< "roomatlas build [OPTIONS] LOG|MAP..."
  CommandNotes notes;
  std::vector<OptionText> places;
  std::vector<OptionGroup> own;         ///< of this command alone, the first without heading
  std::vector<OptionGroup> parameters;  ///< of the stages that it runs
};

struct ProgramText {
  std::string name;
  std::string meaning;
  std::vector<OptionText> common;       ///< of every command
  std::vector<OptionGroup> parameters;  ///< of all stages
  std::vector<CommandText> commands;    ///< those without group are for scripts

  /// Throws std::logic_error where there is none.
  [[nodiscard]] const CommandText& command(const std::string& name) const;
};

/// @param app the program, not one of its commands
[[nodiscard]] ProgramText text_of(const CLI::App& app);

}  // namespace roomatlas::apps
