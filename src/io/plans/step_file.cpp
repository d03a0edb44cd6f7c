// SPDX-License-Identifier: GPL-3.0-or-later
#include "step_file.hpp"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string_view>

#include "roomatlas/core/issue.hpp"
#include "roomatlas/core/utf8.hpp"
#include "roomatlas/io/text/utf8.hpp"
#include "text/numbers.hpp"

namespace roomatlas::io::step {
namespace {

/// ISO 10303-21, 6.4.3: \X2\ for what lies in the basic plane, \X4\ beyond.
std::string escaped(std::uint32_t code) {
  char letters[24];
  const bool is_basic = code <= 0xffffU;
  std::snprintf(letters, sizeof letters, is_basic ? "\\X2\\%04X\\X0\\" : "\\X4\\%08X\\X0\\", code);
  return letters;
}

}  // namespace

Value text(const std::string& utf8) {
  const std::string valid = as_utf8(utf8);
  std::string written = "'";
  for (std::string_view left = valid; !left.empty();) {
    const auto [code, bytes, is_whole] = first_character(left);
    left.remove_prefix(bytes);
    if (code == '\'' || code == '\\') {
      written.append(2, static_cast<char>(code));
    } else if (code >= 0x20U && code < 0x7fU) {
      written += static_cast<char>(code);
    } else {
      written += escaped(code);
    }
  }
  return written + "'";
}

Value real(double value) {
  if (!std::isfinite(value)) throw InputError("plan: a coordinate or size is not finite");
  std::string written;
  append_number(written, std::round(value * 1e9) / 1e9 + 0.0);
  return written.find('.') == std::string::npos ? written + "." : written;
}

Value list(const std::vector<Value>& values) {
  std::string written = "(";
  for (const Value& value : values) written += (written.size() > 1 ? "," : "") + value;
  return written + ")";
}

Value word(const std::string& name) { return "." + name + "."; }

Value File::add(const std::string& type, const std::vector<Value>& arguments) {
  const Value reference = "#" + std::to_string(++count_);
  data_ += reference + "=" + type + list(arguments) + ";\n";
  return reference;
}

Value File::shared(const std::string& type, const std::vector<Value>& arguments) {
  const std::string written = type + list(arguments);
  const auto [entry, is_new] = shared_.try_emplace(written);
  if (is_new) entry->second = add(type, arguments);
  return entry->second;
}

std::string File::finish(const std::string& schema, const std::string& description,
                         const std::string& name, const std::string& time) const {
  return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((" + text(description) +
         "),'2;1');\nFILE_NAME(" + text(name) + "," + text(time) +
         ",(''),(''),'Roomatlas','Roomatlas','');\nFILE_SCHEMA((" + text(schema) +
         "));\nENDSEC;\nDATA;\n" + data_ + "ENDSEC;\nEND-ISO-10303-21;\n";
}

}  // namespace roomatlas::io::step
