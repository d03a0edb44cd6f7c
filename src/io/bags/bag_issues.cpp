// SPDX-License-Identifier: GPL-3.0-or-later
#include "bag_issues.hpp"

#include <algorithm>

namespace roomatlas::io {
namespace {

constexpr const char* kChunks = "chunks";

}  // namespace

void BagIssues::add(Severity severity, const std::string& what, const std::string& things,
                    std::int64_t count) {
  const auto known = std::find_if(kinds_.begin(), kinds_.end(),
                                  [&](const Kind& kind) { return kind.what == what; });
  if (known == kinds_.end()) {
    kinds_.push_back({severity, what, things, count, 0});
  } else {
    known->count += count;
  }
}

void BagIssues::left_out(const std::string& what, std::int64_t messages) {
  add(Severity::warning, what, kChunks, 1);
  for (Kind& kind : kinds_) {
    if (kind.what == what) kind.messages += messages;
  }
}

void BagIssues::take(const Issues& others) {
  taken_.insert(taken_.end(), others.begin(), others.end());
}

Issues BagIssues::list() const {
  Issues issues = taken_;
  for (const Kind& kind : kinds_) {
    std::string message = kind.what;
    if (!kind.things.empty()) {
      message += " (" + std::to_string(kind.count) + " " + kind.things;
      if (kind.things == kChunks) {
        message += ", " + std::to_string(kind.messages) + " messages known of in them";
      }
      message += ")";
    }
    issues.push_back({kind.severity, file_, 0, "", message});
  }
  return issues;
}

}  // namespace roomatlas::io
