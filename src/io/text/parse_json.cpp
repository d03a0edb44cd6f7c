// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/parse_json.hpp"

#include "roomatlas/core/issue.hpp"
#include "text/json.hpp"

#include <algorithm>

namespace roomatlas::io {

Json parse_json(const std::string& text, const std::string& file) {
  if (nests_too_deep(text)) {
    throw InputError(file +
                     ": nests deeper than 64 levels: expected GeoJSON or a list of statements, "
                     "which have ten: is it the right file?");
  }
  try {
    return Json::parse(text);
  } catch (const Json::exception& error) {
    std::string what = error.what();  // "[json.exception.parse_error.101] parse error at ..."
    what.erase(0, std::min(what.size(), what.find("] ") + 2));
    throw InputError(file + ": not valid JSON: " + what);
  }
}

bool nests_too_deep(std::string_view json) {
  constexpr int kDeepest = 64;
  int depth = 0;
  bool is_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (is_text) {
      if (c == '\\') ++i;
      if (c == '"') is_text = false;
      continue;
    }
    if (c == '"') is_text = true;
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
    if (depth > kDeepest) return true;
  }
  return false;
}

}  // namespace roomatlas::io
