// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/plans/spans_file.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "roomatlas/core/issue.hpp"
#include "text/line_reader.hpp"
#include "text/numbers.hpp"
#include "text/tokens.hpp"

namespace roomatlas {
namespace {

using io::Tokens;

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The four fields of a line; nothing when there are more or fewer.
std::optional<std::array<std::string_view, 4>> fields_of(std::string_view line) {
  std::array<std::string_view, 4> fields;
  std::size_t count = 0;
  while (true) {
    const auto comma = line.find(',');
    if (count == fields.size()) return std::nullopt;
    fields[count++] = trimmed(line.substr(0, comma));
    if (comma == std::string_view::npos) break;
    line.remove_prefix(comma + 1);
  }
  if (count != fields.size()) return std::nullopt;
  return fields;
}

std::optional<std::int64_t> id_of(std::string_view word) {
  const auto number = io::parse_number(word);
  if (!number || !(*number >= 1.0 && *number < 1e15) || *number != std::floor(*number)) {
    return std::nullopt;
  }
  return static_cast<std::int64_t>(*number);
}

std::optional<Side> side_of(std::string_view word) {
  if (word == "east") return Side::east;
  if (word == "north") return Side::north;
  if (word == "west") return Side::west;
  if (word == "south") return Side::south;
  return std::nullopt;
}

/// `door 3`, `room 3 west` or `x y`.
std::optional<SpanEnd> end_of(std::string_view text) {
  Tokens words(text);
  const std::size_t count = words.count();
  const std::string_view first = words.next();
  const std::string_view second = words.next();
  if (first == "door" && count == 2) {
    if (const auto id = id_of(second)) return DoorEnd{*id};
  } else if (first == "room" && count == 3) {
    const auto id = id_of(second);
    const auto side = side_of(words.next());
    if (id && side) return WallEnd{*id, *side};
  } else if (count == 2) {
    const auto x = io::parse_number(first);
    const auto y = io::parse_number(second);
    if (x && y && std::isfinite(*x) && std::isfinite(*y)) return PointEnd{{*x, *y}};
  }
  return std::nullopt;
}

/// What is wrong with the line, or empty.
std::string read_line(std::string_view line, std::vector<Span>& spans) {
  const auto fields = fields_of(line);
  if (!fields) return "expected four fields: name, from, to, metres";
  const auto& [name, from_text, to_text, metres_text] = *fields;
  const char* ends = ": expected `door 3`, `room 3 west` or `x y`, found ";
  const auto from = end_of(from_text);
  if (!from) return "from" + std::string(ends) + io::quoted(from_text);
  const auto to = end_of(to_text);
  if (!to) return "to" + std::string(ends) + io::quoted(to_text);
  const auto metres = io::parse_number(metres_text);
  if (!metres || !(*metres > 0.0) || !std::isfinite(*metres)) {
    return "metres: expected a number more than 0, found " + io::quoted(metres_text);
  }
  spans.push_back({std::string(name), *from, *to, *metres});
  return {};
}

}  // namespace

std::vector<Span> read_spans(const std::filesystem::path& file) {
  io::LineReader reader(file);
  std::vector<Span> spans;
  while (const auto full = reader.next()) {
    const std::string_view line = trimmed(full->substr(0, full->find('#')));
    if (line.empty()) continue;
    const std::string wrong = read_line(line, spans);
    if (!wrong.empty()) {
      throw InputError(file.string() + ":" + std::to_string(reader.line_number()) + ": " + wrong +
                       "; correct or delete the line");
    }
  }
  if (spans.empty()) throw InputError(file.string() + ": holds no span");
  return spans;
}

}  // namespace roomatlas
