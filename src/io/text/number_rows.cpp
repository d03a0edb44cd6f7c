// SPDX-License-Identifier: GPL-3.0-or-later
#include "number_rows.hpp"

#include "line_reader.hpp"
#include "numbers.hpp"
#include "tokens.hpp"

#include "roomatlas/core/issue.hpp"

#include <cmath>

namespace roomatlas::io {
namespace {

std::string names_of(const std::vector<std::string>& columns) {
  std::string names;
  for (const std::string& column : columns) names += (names.empty() ? "" : " ") + column;
  return names;
}

/// What is wrong with the row, or empty.
std::string read_row(Tokens fields, const std::vector<std::string>& columns,
                     std::vector<double>& row) {
  if (const std::size_t count = fields.count(); count != columns.size()) {
    return "expected " + std::to_string(columns.size()) + " numbers (" + names_of(columns) +
           "), found " + std::to_string(count) + " fields";
  }
  row.clear();
  for (const std::string& column : columns) {
    const std::string_view token = fields.next();
    const std::optional<double> number = parse_number(token);
    if (!number || !std::isfinite(*number)) {
      return column + ": expected a finite number, found " + quoted(token);
    }
    row.push_back(*number);
  }
  return {};
}

}  // namespace

void read_number_rows(const std::filesystem::path& file, const std::vector<std::string>& columns,
                      const std::function<std::string(std::span<const double>)>& use) {
  LineReader reader(file);
  std::vector<double> row;
  const auto where = [&] { return file.string() + ":" + std::to_string(reader.line_number()); };
  while (const std::optional<std::string_view> line = reader.next()) {
    if (reader.line_is_too_long()) throw InputError(where() + ": the line is too long");
    const Tokens fields(line->substr(0, line->find('#')));
    if (fields.at_end()) continue;
    std::string wrong = read_row(fields, columns, row);
    if (wrong.empty()) wrong = use(row);
    if (!wrong.empty()) throw InputError(where() + ": " + wrong + "; correct or delete the line");
  }
  if (reader.end() != LineReader::End::complete) {
    throw InputError(where() + ": the gzip data ends here; copy the file again");
  }
}

}  // namespace roomatlas::io
