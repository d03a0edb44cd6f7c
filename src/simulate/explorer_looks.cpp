// SPDX-License-Identifier: GPL-3.0-or-later
// What is left to look at when no frontier and no door is: gaps too narrow to pass, which may be
// wider from near by, where jambs echoed into a door's opening; and doorways that the robot saw
// from both sides and never went through.
#include "explorer.hpp"
#include "explorer_doorways.hpp"

#include <algorithm>

namespace roomatlas {
namespace {

constexpr double kGapM = 0.6;     // how far into a gap too narrow to pass the robot would look
constexpr double kMiddleM = 0.1;  // so near the doorway's middle the robot stands in it
constexpr double kPassedM = 0.2;  // of its track: a doorway there was used
constexpr int kHeadings = 12;     // of doorways, in a half turn

const auto never = [](const Cell&) { return false; };

}  // namespace

std::optional<Explorer::Goal> Explorer::look_goal(const Point2& position) {
  (void)paths_.way(map_, position, never, never);
  std::erase_if(to_look_from_, [&](const Cell& cell) { return !is_worth_a_look(cell); });
  if (to_look_from_.empty()) {
    for_each_cell(map_.box(), [&](const Cell& cell) {
      if (is_worth_a_look(cell)) to_look_from_.push_back(cell);
    });
  }
  if (to_look_from_.empty()) return std::nullopt;
  std::unordered_set<std::int64_t> wanted;
  for (const Cell& cell : to_look_from_) wanted.insert(key_of(cell));
  auto way = paths_.way(
      map_, position, [&](const Cell& cell) { return wanted.contains(key_of(cell)); }, never);
  if (!way) return std::nullopt;
  return Goal{{}, rooms_.current(), true, true, deadline_s(*way), std::move(*way)};
}

/// Asked after a search for ways to everywhere.
bool Explorer::is_worth_a_look(const Cell& cell) const {
  return paths_.reached(cell) && map_.is_passable(cell) && !given_up_.contains(key_of(cell)) &&
         (opens_a_gap(cell) || is_in_unused_doorway(cell));
}

/// Whether free floor too narrow for the robot leads from here to floor where it could be, or to
/// something unseen.
bool Explorer::opens_a_gap(const Cell& cell) const {
  const int reach = static_cast<int>(kGapM / map_.frame().cell_m);
  std::vector<Cell> found = {cell};
  std::unordered_set<std::int64_t> seen = {key_of(cell)};
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Cell at = found[i];
    for (const Cell& next :
         {Cell{at.x + 1, at.y}, Cell{at.x - 1, at.y}, Cell{at.x, at.y + 1}, Cell{at.x, at.y - 1}}) {
      if (paths_.reached(next) || distance_cells(next, cell) > reach || !map_.is_narrow(next) ||
          !seen.insert(key_of(next)).second) {
        continue;
      }
      if (map_.is_passable(next) || map_.borders_large_unknown(next)) return true;
      found.push_back(next);
    }
  }
  return false;
}

/// Whether this is the middle of a doorway that the robot kept away from.
bool Explorer::is_in_unused_doorway(const Cell& cell) const {
  if (!map_.is_tight(cell)) return false;
  const Point2 middle = map_.frame().center_of(cell);
  for (int i = 0; i < kHeadings; ++i) {
    const Pose2 through{middle.x(), middle.y(), kPi * i / kHeadings};
    if (!map_.is_between_obstacles(through)) continue;
    const auto doorway = seen_doorway(map_, through);
    if (!doorway || (doorway->frame_from_pivot.position() - middle).norm() > kMiddleM) continue;
    return std::none_of(track_.begin(), track_.end(),
                        [&](const Point2& at) { return (at - middle).norm() <= kPassedM; });
  }
  return false;
}

}  // namespace roomatlas
