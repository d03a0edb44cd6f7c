// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <utility>

#include "parameters.hpp"
#include "settings.hpp"

namespace roomatlas::apps {

/// Adds parameters of one stage.
class ParameterList {
 public:
  ParameterList(Parameters& all, Stage stage) : all_(all), stage_(stage) {}

  template <typename Value>
  void add(const std::string& name, Value& value, const std::string& meaning, double low,
           double high) {
    all_.push_back({stage_, name, meaning, NumberParameter{&value, low, high}});
  }
  /// An angle that is given in degrees and kept in radians.
  void degrees(const std::string& name, double& value_rad, const std::string& meaning, double low,
               double high) {
    all_.push_back({stage_, name, meaning, DegreesParameter{&value_rad, low, high}});
  }
  void flag(const std::string& name, bool& value, const std::string& meaning) {
    all_.push_back({stage_, name, meaning, FlagParameter{&value}});
  }
  void text(const std::string& name, std::string& value, const std::string& meaning) {
    all_.push_back({stage_, name, meaning, TextParameter{&value}});
  }
  void file(const std::string& name, std::string& value, const std::string& meaning) {
    all_.push_back({stage_, name, meaning, FileParameter{&value}});
  }
  template <typename Choice>
  void choice(const std::string& name, Choice& value, const std::string& meaning,
              const std::map<std::string, Choice>& names) {
    std::string now;
    for (const auto& [text, choice] : names) {
      if (choice == value) now = text;
    }
    add_choice(name, meaning, names, now, [&value](const Choice& choice) { value = choice; });
  }
  /// A name that stands for several values.
  template <typename Choice, typename Apply>
  void preset(const std::string& name, const std::map<std::string, Choice>& names,
              const std::string& meaning, Apply apply) {
    add_choice(name, meaning, names, "mild", apply);
  }

 private:
  template <typename Choice, typename Apply>
  void add_choice(const std::string& name, const std::string& meaning,
                  const std::map<std::string, Choice>& names, const std::string& now, Apply apply) {
    ChoiceParameter choice;
    for (const auto& entry : names) choice.names.push_back(entry.first);
    choice.now = now;
    choice.choose = [names, apply](const std::string& text) { apply(names.at(text)); };
    all_.push_back({stage_, name, meaning, std::move(choice)});
  }

  Parameters& all_;
  Stage stage_;
};

/// Those of the simulator, which map nothing.
void add_simulation(Parameters& all, Settings& settings);

}  // namespace roomatlas::apps
