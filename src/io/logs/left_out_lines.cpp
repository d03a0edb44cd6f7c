// SPDX-License-Identifier: GPL-3.0-or-later
#include "left_out_lines.hpp"

#include "carmen_message.hpp"

#include "roomatlas/io/logs/open_mission.hpp"

#include <algorithm>

namespace roomatlas::io {
namespace {

bool can_hold_ranges(const std::string& tag) {
  const CarmenTag* carmen = find_carmen_tag(tag);
  if (carmen == nullptr) return tag == "L" || tag == "Laser" || tag == "scan";
  return carmen->kind == CarmenKind::laser || carmen->kind == CarmenKind::sonar;
}

}  // namespace

void LeftOutLines::add(const std::string& tag, std::int64_t line, const std::string& why) {
  if (of_tag_.size() >= kMostTags && !of_tag_.contains(tag)) return;
  Lines& lines = of_tag_[tag];
  if (++lines.count > 1) return;
  lines.first_line = line;
  lines.why = why;
}

void LeftOutLines::explain(MissionInfo& info) const {
  std::string text;
  const bool no_ranges = info.readings == 0;
  for (const auto& [tag, lines] : of_tag_) {
    const bool is_missed = no_ranges ? can_hold_ranges(tag) : tag == "ODOM";
    if (!is_missed || info.line_counts.contains(tag)) continue;
    text += (text.empty() ? "" : ". ") + std::to_string(lines.count) + " " + tag +
            " lines, all left out; the first: line " + std::to_string(lines.first_line) + ": " +
            lines.why;
  }
  if (text.empty() || !(no_ranges || info.odometry == "none")) return;
  info.issues.insert(info.issues.begin(), {Severity::error, info.file, 0,
                                           no_ranges ? "no range readings" : "no odometry", text});
}

}  // namespace roomatlas::io

namespace roomatlas {

void require_lines_that_could_be_read(const MissionInfo& info) {
  const auto found = std::find_if(info.issues.begin(), info.issues.end(), [](const Issue& issue) {
    return issue.severity == Severity::error;
  });
  if (found != info.issues.end()) throw NotEnoughError(to_string(*found));
}

}  // namespace roomatlas
