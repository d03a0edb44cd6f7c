// SPDX-License-Identifier: GPL-3.0-or-later
#include "changes/score_changes.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <utility>

namespace roomatlas::bench {
namespace {

constexpr double kNear_m = 0.5;  // from what was altered to the middle of what is told

/// Doors, furniture or walls.
int family_of(ChangeKind kind) { return static_cast<int>(kind) / 3; }

double distance_m(const Alteration& alteration, const Point2& at) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Polygon& outline : alteration.outlines) {
    nearest_m =
        std::min(nearest_m, contains(outline, at) ? 0.0 : distance_to_boundary(outline.outer, at));
  }
  return nearest_m;
}

std::string remark(const char* what, ChangeKind kind, const Point2& at) {
  char text[128];
  std::snprintf(text, sizeof text, "%s: %s at %.2f, %.2f", what, to_string(kind), at.x(), at.y());
  return text;
}

/// Alterations by their place, and as what they were told.
using Told = std::vector<std::pair<std::size_t, ChangeKind>>;

/// Whether it is the rest of a piece that was moved: told as one that is gone and one that is new.
bool is_other_half(const Change& change, const Point2& at,
                   const std::vector<Alteration>& alterations, const Told& told) {
  return std::any_of(told.begin(), told.end(), [&](const auto& entry) {
    const auto& [place, kind] = entry;
    const bool is_pair =
        (kind == ChangeKind::furniture_gone && change.kind == ChangeKind::furniture_new) ||
        (kind == ChangeKind::furniture_new && change.kind == ChangeKind::furniture_gone);
    return is_pair && alterations[place].kind == ChangeKind::furniture_moved &&
           distance_m(alterations[place], at) <= kNear_m;
  });
}

}  // namespace

double ChangeScore::precision() const {
  return found + invented > 0 ? static_cast<double>(found) / (found + invented) : 1.0;
}

double ChangeScore::recall() const {
  return altered > 0 ? static_cast<double>(found) / altered : 1.0;
}

double ChangeScore::f1() const {
  const double sum = precision() + recall();
  return sum > 0.0 ? 2.0 * precision() * recall() / sum : 0.0;
}

void ChangeScore::add(const ChangeScore& other) {
  altered += other.altered;
  found += other.found;
  named += other.named;
  invented += other.invented;
}

ChangeScore scored(const std::vector<Alteration>& alterations, const std::set<RoomId>& seen,
                   const std::vector<Change>& changes, const Pose2& world_from_old) {
  ChangeScore score;
  std::vector<bool> is_told(alterations.size(), false);
  Told told;
  for (const Change& change : changes) {
    const Point2 at = world_from_old * change.at;
    std::size_t best = alterations.size();
    double least_m = kNear_m;
    for (std::size_t i = 0; i < alterations.size(); ++i) {
      if (is_told[i] || family_of(alterations[i].kind) != family_of(change.kind)) continue;
      if (distance_m(alterations[i], at) > least_m) continue;
      least_m = distance_m(alterations[i], at);
      best = i;
    }
    if (best == alterations.size() && is_other_half(change, at, alterations, told)) continue;
    if (best == alterations.size()) {
      ++score.invented;
      score.remarks.push_back(remark("invented", change.kind, at));
      continue;
    }
    is_told[best] = true;
    told.emplace_back(best, change.kind);
    const auto& rooms = alterations[best].rooms;
    if (std::none_of(rooms.begin(), rooms.end(), [&](RoomId id) { return seen.contains(id); })) {
      continue;
    }
    ++score.found;
    if (alterations[best].kind == change.kind) {
      ++score.named;
    } else {
      score.remarks.push_back(remark("misnamed", change.kind, at) + ", is " +
                              to_string(alterations[best].kind));
    }
  }
  for (std::size_t i = 0; i < alterations.size(); ++i) {
    const auto& rooms = alterations[i].rooms;
    if (std::none_of(rooms.begin(), rooms.end(), [&](RoomId id) { return seen.contains(id); })) {
      continue;
    }
    ++score.altered;
    if (!is_told[i]) {
      score.remarks.push_back(remark("missed", alterations[i].kind, alterations[i].to));
    }
  }
  return score;
}

}  // namespace roomatlas::bench
