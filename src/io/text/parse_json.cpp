// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/parse_json.hpp"

#include "roomatlas/core/issue.hpp"
#include "text/json.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace roomatlas::io {

namespace {

/// Of two values of one name all but one would be dropped without a word.
class UniqueKeys {
 public:
  explicit UniqueKeys(std::string file) : file_(std::move(file)) {}

  void check(Json::parse_event_t event, const Json& parsed) {
    if (event == Json::parse_event_t::object_start) keys_.emplace_back();
    if (event == Json::parse_event_t::object_end) keys_.pop_back();
    if (event != Json::parse_event_t::key) return;
    const std::string key = parsed.get<std::string>();
    if (keys_.back().insert(key).second) return;
    throw InputError(file_ + ": field \"" + key.substr(0, kShown) +
                     "\" stands twice in one object: which of them holds? Leave one out");
  }

 private:
  static constexpr std::size_t kShown = 60;  // bytes

  std::string file_;
  std::vector<std::set<std::string>> keys_;  ///< of the objects around, the outermost first
};

}  // namespace

Json parse_json(const std::string& text, const std::string& file) {
  if (nests_too_deep(text)) {
    throw InputError(file +
                     ": nests deeper than 64 levels: expected GeoJSON or a list of statements, "
                     "which have ten: is it the right file?");
  }
  UniqueKeys unique(file);
  try {
    return Json::parse(text, [&](int, Json::parse_event_t event, const Json& parsed) {
      unique.check(event, parsed);
      return true;
    });
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
