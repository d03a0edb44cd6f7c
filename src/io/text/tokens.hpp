// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace roomatlas::io {

/// Walks over the fields of a line that blanks separate. Copying it is cheap and looks ahead.
class Tokens {
 public:
  explicit Tokens(std::string_view line);

  /// The next field; empty at the end of the line.
  [[nodiscard]] std::string_view next();
  [[nodiscard]] bool at_end() const { return rest_.empty(); }
  /// How many fields are left.
  [[nodiscard]] std::size_t count() const;
  /// How many of the fields that are left are numbers.
  [[nodiscard]] std::size_t count_numbers() const;

 private:
  std::string_view rest_;  ///< begins with a field, or is empty
};

/// A field as a message may show it: in quotes, short, printable.
[[nodiscard]] std::string quoted(std::string_view token);

}  // namespace roomatlas::io
