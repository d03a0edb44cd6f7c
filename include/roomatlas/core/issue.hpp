// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
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

/// A stage was asked to stop (exit code 130).
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace roomatlas
