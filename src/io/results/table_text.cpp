// SPDX-License-Identifier: GPL-3.0-or-later
#include "table_text.hpp"

#include "text/numbers.hpp"

#include <cmath>
#include <cstdio>

namespace roomatlas::io {

std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

void add_csv(std::string& line, double value) {
  line += ',';
  if (std::isfinite(value)) append_number(line, value);
}

std::string latex_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\\') {
      escaped += "\\textbackslash{}";
    } else if (c == '~' || c == '^') {
      escaped += std::string("\\") + c + "{}";
    } else {
      if (std::string("&%$#_{}").find(c) != std::string::npos) escaped += '\\';
      escaped += c;
    }
  }
  return escaped;
}

std::string short_number(double value) {
  if (!std::isfinite(value)) return "--";
  char text[64];
  const double size = std::abs(value);
  const int decimals = size >= 100.0 ? 1 : size >= 1.0 ? 2 : size >= 0.1 ? 3 : 4;
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

}  // namespace roomatlas::io
