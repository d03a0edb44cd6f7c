// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace roomatlas {

enum class Severity { note, warning, error };

/// Imperfect data, as a value: nothing is dropped without one of these.
struct Issue {
  Severity severity = Severity::warning;
  std::string file;       ///< empty where the subject is not a file
  std::int64_t line = 0;  ///< 1-based; 0 where there is no line
  std::string field;      ///< the name of the field or object at fault
  std::string message;    ///< what was found, what was expected, what to do
};

using Issues = std::vector<Issue>;

/// `file:line: field: message`, leaving out what is empty.
[[nodiscard]] std::string to_string(const Issue& issue);

/// The command line or a configuration is wrong (exit code 2).
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An input is missing or unreadable (exit code 3).
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The input is readable but holds too little to map (exit code 4).
struct NotEnoughError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Called now and then by long stages. `done` is in [0, 1], or negative where unknown.
/// Return false to ask the stage to stop: it throws `Interrupted` at a consistent point.
using Progress = std::function<bool(const std::string& stage, double done)>;

struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace roomatlas
