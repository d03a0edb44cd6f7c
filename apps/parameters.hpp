// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of all stages as a list: what the command line, the configuration file, the help
// and the store say of them comes from here. What each belongs to is said by the options' own tree.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace roomatlas::apps {

struct Settings;

inline constexpr double kLargestSeed = 1e15;  // every whole number up to here is a double

/// The branch of the options that a parameter stands in.
enum class Stage {
  mission,
  rooms,
  correction,
  plan,
  simulation,
  run,  ///< how the program works, not what comes out: kept in no store and no configuration
};

/// The heading of the help above a stage's parameters.
[[nodiscard]] const char* heading_of(Stage stage);

/// True where a store's rooms hang on the parameters of a stage.
[[nodiscard]] constexpr bool is_of_mapping(Stage stage) {
  return stage == Stage::mission || stage == Stage::rooms;
}

struct NumberParameter {
  std::variant<double*, int*, std::uint64_t*> value;
  double low = 0.0;
  double high = 0.0;
};
/// An angle: degrees for people, radians in the options.
struct DegreesParameter {
  double* value_rad = nullptr;
  double low_deg = 0.0;
  double high_deg = 0.0;
};
struct FlagParameter {
  bool* value = nullptr;
};
/// One of a few names.
struct ChoiceParameter {
  std::vector<std::string> names;
  std::string now;
  std::function<void(const std::string&)> choose;
};
/// A text, which may be empty. Given several times, its texts are joined by commas.
struct TextParameter {
  std::string* value = nullptr;
};
/// The name of a file: never kept in a store.
struct FileParameter {
  std::string* value = nullptr;
};

struct Parameter {
  Stage stage = Stage::mission;
  std::string name;
  std::string meaning;
  std::variant<NumberParameter, DegreesParameter, FlagParameter, ChoiceParameter, TextParameter,
               FileParameter>
      kind;
};
using Parameters = std::vector<Parameter>;

/// All parameters, once, in the order of the help. They point into `settings`.
[[nodiscard]] Parameters parameters_of(Settings& settings);

}  // namespace roomatlas::apps
