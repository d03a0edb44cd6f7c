// SPDX-License-Identifier: GPL-3.0-or-later
#include "ros1_md5.hpp"

#include <openssl/evp.h>

#include <array>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace roomatlas::io {
namespace {

constexpr int kDeepestType = 32;  // types in types; a circle has no end

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::optional<std::string> md5(const std::string& text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned size = 0;
  if (EVP_Digest(text.data(), text.size(), digest.data(), &size, EVP_md5(), nullptr) != 1) {
    return std::nullopt;
  }
  constexpr const char* kHex = "0123456789abcdef";
  std::string hex;
  for (unsigned i = 0; i < size; ++i) hex += {kHex[digest[i] >> 4], kHex[digest[i] & 15]};
  return hex;
}

using Definitions = std::map<std::string, std::vector<std::string_view>, std::less<>>;

/// The lines of each type: the first one's, then those behind "MSG: type".
Definitions definitions_of(std::string_view type, std::string_view text) {
  Definitions definitions;
  std::string current(type);
  definitions[current];
  for (const std::string_view line : lines_of(text)) {
    if (line.starts_with("====")) continue;
    if (line.starts_with("MSG: ")) {
      current = trimmed(line.substr(5));
    } else {
      definitions[current].push_back(line);
    }
  }
  return definitions;
}

bool is_built_in(std::string_view type) {
  static const std::set<std::string_view> kBuiltIn = {
      "bool",   "int8",    "uint8",   "int16",  "uint16", "int32",    "uint32", "int64",
      "uint64", "float32", "float64", "string", "time",   "duration", "char",   "byte"};
  return kBuiltIn.contains(type);
}

std::string full_name(std::string_view type, std::string_view inside) {
  if (type == "Header") return "std_msgs/Header";
  if (type.find('/') != std::string_view::npos) return std::string(type);
  return std::string(inside.substr(0, inside.find('/') + 1)) + std::string(type);
}

std::optional<std::string> sum_of(const std::string& type, const Definitions& definitions,
                                  int depth) {
  const auto lines = definitions.find(type);
  if (lines == definitions.end() || depth > kDeepestType) return std::nullopt;
  std::string constants;
  std::string members;
  for (const std::string_view raw : lines->second) {
    const std::string_view line = trimmed(raw.substr(0, raw.find('#')));
    const std::size_t blank = line.find_first_of(" \t");
    if (line.empty() || blank == std::string_view::npos) continue;
    const std::string_view member = line.substr(0, blank);
    const std::string_view name = trimmed(line.substr(blank));
    const std::size_t equals = name.find('=');
    if (equals != std::string_view::npos) {
      // A constant text goes to the line's end, what looks like a comment included.
      const std::string_view value =
          trimmed(member == "string" ? raw.substr(raw.find('=') + 1) : name.substr(equals + 1));
      constants += std::string(member) + " " + std::string(trimmed(name.substr(0, equals))) + "=" +
                   std::string(value) + "\n";
      continue;
    }
    const std::string_view single = member.substr(0, member.find('['));
    std::string shown(member);
    if (!is_built_in(single)) {
      const auto inner = sum_of(full_name(single, type), definitions, depth + 1);
      if (!inner) return std::nullopt;
      shown = *inner;
    }
    members += shown + " " + std::string(name) + "\n";
  }
  std::string text = constants + members;
  if (!text.empty()) text.pop_back();
  return md5(text);
}

}  // namespace

std::string ros1_md5(std::string_view type, std::string_view definition) {
  if (definition.empty()) return "*";
  return sum_of(std::string(type), definitions_of(type, definition), 0).value_or("*");
}

}  // namespace roomatlas::io
