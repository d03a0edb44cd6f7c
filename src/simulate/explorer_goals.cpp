// SPDX-License-Identifier: GPL-3.0-or-later
#include "explorer.hpp"
#include "explorer_doorways.hpp"

#include <cmath>

namespace roomatlas {
namespace {

constexpr double kRenewEveryS = 0.6;   // ways are found anew on what has been seen since
constexpr double kRenewShare = 0.1;    // ... and the rarer the longer they are: they cost more
constexpr double kAtGoalM = 0.12;      // so near, it is there; less lets it dance about a goal
constexpr double kGiveUpM = 0.3;       // frontiers this near to a hopeless one are hopeless too
constexpr double kDoorSkipM = 0.2;     // of the way ahead, beside the robot itself
constexpr double kBeyondDoorM = 0.45;  // how far behind a door its way ends
constexpr int kStuckGoals = 10;        // given up one after the other: then it is stuck
constexpr double kGoalS = 15.0;        // what a goal may take at least, to turn and get clear ...
constexpr double kSlowness = 4.0;      // ... and beside it so many times what the bare way takes

}  // namespace

bool Explorer::is_wanted_frontier(const Cell& cell) const {
  return map_.is_frontier(cell) && !given_up_.contains(key_of(cell));
}

double Explorer::deadline_s(const Polyline& way) const {
  return time_s_ + kGoalS + kSlowness * length(way) / options_.speed_m_per_s;
}

/// When nothing is left, what was given up is tried once more: it may be clearer now.
std::optional<Explorer::Goal> Explorer::next_goal(const Point2& position) {
  auto goal = next_new_goal(position);
  if (!goal && !has_tried_again_) {
    has_tried_again_ = true;
    given_up_.clear();
    rooms_.forget_failures();
    goal = next_new_goal(position);
  }
  return goal ? goal : look_goal(position);
}

std::optional<Explorer::Goal> Explorer::next_new_goal(const Point2& position) {
  if (auto goal = frontier_goal(position)) return goal;
  for (const ExplorerRooms::Door door : rooms_.untaken()) {
    if (auto goal = door_goal(door, position)) return goal;
    rooms_.note_failure(door);
  }
  while (const auto door = rooms_.way_back()) {
    if (auto goal = door_goal(*door, position)) return goal;
    rooms_.note_failure(*door);
  }
  return leftover_goal(position);
}

std::optional<Explorer::Goal> Explorer::frontier_goal(const Point2& position) {
  for (;;) {
    auto way = paths_.way(
        map_, position, [&](const Cell& cell) { return is_wanted_frontier(cell); },
        [&](const Cell& cell) { return rooms_.is_closed(cell, zone_); });
    if (!way) return std::nullopt;
    if (find_doorway_on(*way, position)) continue;
    return Goal{{}, rooms_.current(), false, false, deadline_s(*way), std::move(*way)};
  }
}

/// A way that leaves through a doorway is no frontier of this room: the door is noted instead.
/// Doorways behind a known door of this room are another room's.
bool Explorer::find_doorway_on(const Polyline& way, const Point2& position) {
  for (std::size_t i = 0; i < way.size(); i += 2) {
    const auto known = rooms_.door_at(way[i]);
    if (known && rooms_.is_here(*known) && rooms_.beyond_m(*known, way[i]) > 0.0) return false;
    if (known || (way[i] - position).norm() < kDoorSkipM) continue;
    const Pose2 at = pose_on_way(way, i);
    const auto doorway = seen_doorway(map_, at);
    if (doorway && rooms_.add(*doorway, a_metre_before(at))) return true;
  }
  return false;
}

std::optional<Explorer::Goal> Explorer::door_goal(ExplorerRooms::Door door,
                                                  const Point2& position) {
  auto way = way_through(door, position);
  if (!way) return std::nullopt;
  return Goal{door, rooms_.current(), false, false, deadline_s(*way), std::move(*way)};
}

/// To behind a door; to its threshold where nothing behind has been seen.
std::optional<Polyline> Explorer::way_through(ExplorerRooms::Door door, const Point2& position) {
  const Doorway& doorway = rooms_.doors()[door].doorway;
  const auto is_in_line = [&](const Point2& at) {
    return std::abs((inverse(doorway.frame_from_pivot) * at).y()) <= doorway.width_m / 2.0;
  };
  const auto closed = [&](const Cell& cell) {
    return rooms_.is_closed(cell, door) && rooms_.is_closed(cell, zone_);
  };
  const auto is_beyond = [&](const Cell& cell) {
    const Point2 at = map_.frame().center_of(cell);
    const double beyond_m = rooms_.beyond_m(door, at);
    return beyond_m >= kBeyondDoorM && beyond_m <= 2.0 * kBeyondDoorM && is_in_line(at);
  };
  const auto is_before = [&](const Cell& cell) {
    const Point2 at = map_.frame().center_of(cell);
    return std::abs(rooms_.beyond_m(door, at)) <= kBeyondDoorM && is_in_line(at) &&
           is_wanted_frontier(cell);
  };
  auto way = paths_.way(map_, position, is_beyond, closed);
  if (!way) way = paths_.way(map_, position, is_before, closed);
  return way;
}

std::optional<Polyline> Explorer::way_to(const Point2& target, bool ignores_doors,
                                         const Point2& position) {
  const Cell target_cell = map_.frame().cell_of(target);
  return paths_.way(
      map_, position, [&](const Cell& cell) { return cell == target_cell; },
      [&](const Cell& cell) { return !ignores_doors && rooms_.is_closed(cell, zone_); });
}

/// What no room claims: a frontier that only a way through several doors reaches.
std::optional<Explorer::Goal> Explorer::leftover_goal(const Point2& position) {
  auto way = paths_.way(
      map_, position, [&](const Cell& cell) { return is_wanted_frontier(cell); },
      [](const Cell&) { return false; });
  if (!way) return std::nullopt;
  return Goal{{}, rooms_.current(), true, false, deadline_s(*way), std::move(*way)};
}

bool Explorer::is_done(const Goal& goal) const {
  if (goal.door) return !zone_ && rooms_.current() != goal.from;
  if (goal.is_look) return false;
  return !is_wanted_frontier(map_.frame().cell_of(goal.way.back()));
}

/// A robot that came to behind a door without passing it has found a way around: it stands in the
/// room on that side.
bool Explorer::is_around(const Goal& goal, const Point2& position) {
  if (!goal.door || zone_ || rooms_.beyond_m(*goal.door, position) < kBeyondDoorM / 2.0) {
    return false;
  }
  rooms_.leave(*goal.door, position, [&] { return known_room_here(position); });
  return true;
}

/// Finds the way anew now and then; false when the goal is given up.
bool Explorer::renew(Goal& goal, const Point2& position) {
  const bool arrived = (goal.way.back() - position).norm() <= kAtGoalM;
  if (time_s_ < renew_s_ && !arrived) return true;
  renew_s_ = time_s_ + kRenewEveryS + kRenewShare * length(goal.way) / options_.speed_m_per_s;
  if (is_done(goal) || (arrived && is_around(goal, position))) return false;
  if (goal.is_look && arrived) {
    want_no_more(map_.frame().cell_of(goal.way.back()));
    return false;
  }
  if (time_s_ > goal.deadline_s || (arrived && !goal.door)) {
    give_up(goal, position);
    return false;
  }
  std::optional<Polyline> way = goal.door ? way_through(*goal.door, position)
                                          : way_to(goal.way.back(), goal.ignores_doors, position);
  if (!goal.door && !goal.ignores_doors && way && find_doorway_on(*way, position)) return false;
  if (!way) {
    if (goal.door) rooms_.note_failure(*goal.door);
    return false;
  }
  goal.way = std::move(*way);
  return true;
}

void Explorer::give_up(const Goal& goal, const Point2& position) {
  ++goals_given_up_;
  if (goal.door) rooms_.note_failure(*goal.door);
  const bool moved = (position - last_moved_).norm() > kStuckM;
  given_up_here_ = moved ? 0 : given_up_here_ + 1;
  if (given_up_here_ >= kStuckGoals) is_stuck_ = true;
  want_no_more(map_.frame().cell_of(goal.way.back()));
}

/// Neither this cell is a goal again nor those around it.
void Explorer::want_no_more(const Cell& around) {
  const int reach = static_cast<int>(kGiveUpM / map_.frame().cell_m);
  for_each_cell(
      {{around.x - reach, around.y - reach}, {around.x + reach + 1, around.y + reach + 1}},
      [&](const Cell& cell) {
        if (distance_cells(cell, around) <= reach) given_up_.insert(key_of(cell));
      });
}

}  // namespace roomatlas
