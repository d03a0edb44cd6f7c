// SPDX-License-Identifier: GPL-3.0-or-later
#include "edited_closures.hpp"

#include <algorithm>
#include <string>

namespace roomatlas {
namespace {

/// The visit during which a moment is; 0 where there is none.
AsrId visit_at(const AsrSource& source, double time_s) {
  for (const AsrId id : source.ids()) {
    const Asr asr = source.get(id, AsrDetail::path);
    if (asr.path.empty()) continue;
    if (asr.path.front().timestamp_s <= time_s && time_s <= asr.path.back().timestamp_s) return id;
  }
  return 0;
}

bool is_of_closures(const Edit& edit) {
  return edit.kind == EditKind::reject_closure || edit.kind == EditKind::pin_visits;
}

std::string not_found(const char* field, double time_s) {
  return "no longer fits and is not applied: " + std::string(field) +
         ": the robot was in no visit at " + std::to_string(time_s) + " s";
}

bool is_between(const Closure& closure, AsrId from, AsrId to) {
  return (closure.from == from && closure.to == to) || (closure.from == to && closure.to == from);
}

/// What is to be said of one of them; empty where it was done.
std::string said(const Edit& edit, AsrId from, AsrId to, const std::vector<Closure>& closures) {
  if (from == 0) return not_found("from_time_s", edit.from_time_s);
  if (to == 0) return not_found("to_time_s", edit.to_time_s);
  if (from == to) {
    return "no longer fits and is not applied: both moments are in visit " + std::to_string(from);
  }
  const std::string between = "visits " + std::to_string(from) + " and " + std::to_string(to);
  const auto found = std::find_if(closures.begin(), closures.end(), [&](const Closure& closure) {
    return is_between(closure, from, to) &&
           (edit.kind == EditKind::reject_closure || closure.was_given);
  });
  if (edit.kind == EditKind::reject_closure) {
    return found != closures.end() ? "" : "no longer fits: " + between + " were not matched";
  }
  if (found != closures.end() && found->verdict == ClosureVerdict::accepted) return {};
  return "is not applied: " + between + " pinned so are " +
         (found == closures.end() ? "not matched" : to_string(found->verdict));
}

}  // namespace

ClosureOptions with_edited_closures(const AsrSource& source, const std::vector<Edit>& edits,
                                    ClosureOptions options) {
  for (const Edit& edit : edits) {
    if (!is_of_closures(edit)) continue;
    const AsrId from = visit_at(source, edit.from_time_s);
    const AsrId to = visit_at(source, edit.to_time_s);
    if (from == 0 || to == 0 || from == to) continue;
    if (edit.kind == EditKind::pin_visits) {
      options.given.push_back({from, to, edit.from_from_to});
    } else {
      options.rejected.push_back({from, to});
    }
  }
  return options;
}

Issues edited_closure_issues(const AsrSource& source, const std::vector<Edit>& edits,
                             const std::vector<Closure>& closures, bool are_sought) {
  Issues issues;
  for (std::size_t i = 0; i < edits.size(); ++i) {
    if (!is_of_closures(edits[i])) continue;
    const std::string why =
        are_sought ? said(edits[i], visit_at(source, edits[i].from_time_s),
                          visit_at(source, edits[i].to_time_s), closures)
                   : "has no effect: rooms are matched only in one mission with a laser whose "
                     "readings are localized and kept, and before it is joined with others";
    if (!why.empty()) issues.push_back(edit_issue(i, edits[i], why));
  }
  return issues;
}

}  // namespace roomatlas
