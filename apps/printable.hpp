// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <type_traits>

namespace roomatlas::apps {

/// A text from a file (a name, a field, a path) as a terminal may show it: control characters, C1
/// controls, marks that turn the direction of writing, and bytes that are not UTF-8 come as `\x1b`
/// or `\u202e`, so that none of them moves the cursor, sets a title or hides what follows.
/// Other characters stay as they are.
[[nodiscard]] std::string printable(std::string_view text);
/// The same line by line.
[[nodiscard]] std::string printable_lines(std::string_view text);

/// What `say` shows of a value: texts printable, all else as it is.
template <typename Value>
decltype(auto) shown(const Value& value) {
  if constexpr (std::is_convertible_v<const Value&, std::string_view>) {
    return printable(std::string_view(value));
  } else {
    return static_cast<const Value&>(value);
  }
}

/// Prints to stdout, for people: every text among the values is made printable. Documents (JSON,
/// TOML, a manual), which escape what they hold, are printed by fmt::print.
template <typename... Values>
void say(fmt::format_string<const Values&...> format, const Values&... values) {
  const auto print = [&](const auto&... texts) {
    fmt::vprint(stdout, fmt::string_view(format), fmt::make_format_args(texts...));
  };
  print(shown(values)...);
}

}  // namespace roomatlas::apps
