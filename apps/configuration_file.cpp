// SPDX-License-Identifier: GPL-3.0-or-later
#include "configuration_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include "roomatlas/core/issue.hpp"
#include "settings.hpp"

namespace roomatlas::apps {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool is_text(const std::string& line) {
  return std::none_of(line.begin(), line.end(),
                      [](unsigned char c) { return c < 32 && c != '\t'; });
}

/// Names are plain letters, so that the message can show them.
bool is_plain(const std::string& name) {
  return std::all_of(name.begin(), name.end(), [](unsigned char c) { return c >= 32 && c < 127; });
}

/// The parameter that a line names.
std::string name_in(const std::string& line) {
  const std::size_t sign = line.find('=');
  std::string name = CLI::detail::trim_copy(line.substr(0, sign));
  if (!is_text(line) || !is_plain(name)) {
    throw UsageError("is no text of parameters: expected lines of name = value");
  }
  if (line.front() == '[') throw UsageError("sections are not used: " + name);
  if (sign == std::string::npos || name.empty()) {
    throw UsageError("expected name = value, found \"" + line + "\"");
  }
  return CLI::detail::remove_quotes(name);
}

/// Reads one line as the program would.
void try_line(const std::string& name, const std::string& line) {
  CLI::App app;
  Settings unused;
  add_parameters(app, unused);
  if (app.get_option_no_throw("--" + name) == nullptr) {
    throw UsageError("no such parameter: " + name);
  }
  std::istringstream in(line);
  try {
    app.parse_from_stream(in);
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
}

void check_line(const std::string& line, std::set<std::string>& names) {
  const std::string text = CLI::detail::trim_copy(line);
  if (text.empty() || text.front() == '#' || text.front() == ';') return;
  const std::string name = name_in(text);
  try_line(name, text);
  if (!names.insert(name).second) throw UsageError(name + " is given twice");
}

void check(const std::string& content, const std::string& file) {
  std::istringstream in(content);
  std::set<std::string> names;
  std::int64_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    try {
      check_line(line, names);
    } catch (const UsageError& wrong) {
      throw UsageError(fmt::format("{}:{}: {}; `roomatlas config --print` shows all parameters",
                                   file, number, wrong.what()));
    }
  }
}

}  // namespace

std::vector<CLI::ConfigItem> ConfigurationFile::from_config(std::istream& input) const {
  std::string content(std::istreambuf_iterator<char>(input), {});
  if (content.starts_with(kByteOrderMark)) content.erase(0, kByteOrderMark.size());
  check(content, app_.get_config_ptr()->as<std::string>());
  std::istringstream checked(content);
  return CLI::ConfigTOML::from_config(checked);
}

}  // namespace roomatlas::apps
