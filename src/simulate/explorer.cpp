// SPDX-License-Identifier: GPL-3.0-or-later
#include "explorer.hpp"

#include "explorer_doorways.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr double kMapEveryM = 0.02;
constexpr double kMapEveryDeg = 1.5;
constexpr double kRenewEveryS = 0.6;  // ways are found anew on what has been seen since
constexpr double kRenewShare = 0.1;   // ... and the rarer the longer they are: they cost more
constexpr double kAtGoalM = 0.12;
constexpr double kGiveUpM = 0.3;  // frontiers this near to a hopeless one are hopeless too
constexpr double kTrackEveryM = 0.05;
constexpr std::size_t kAnchorEvery = 10;  // of the track's points
constexpr double kLookBehindM = 0.6;      // both jambs have been seen by then
constexpr double kDoorSkipM = 0.2;        // of the way ahead, beside the robot itself
const Point2 kBefore{-1.0, 0.0};          // a point on this side of a door, seen from its line
constexpr double kBeyondDoorM = 0.45;     // how far behind a door its way ends
constexpr double kProgressM = 0.1;
constexpr double kProgressDeg = 15.0;
constexpr double kPatienceS = 4.0;
constexpr double kShuffleS = 1.0;
constexpr double kCaughtM = 0.5;  // so far away it is free again
constexpr int kCalmShuffles = 4;  // caught oftener in one place, it goes back
constexpr double kLeastRetreatM = 0.15;
constexpr double kRetreatM = 1.0;  // at most
constexpr double kStuckM = 0.15;
constexpr int kStuckGoals = 10;

/// The way's direction around its i-th point.
Pose2 pose_on(const Polyline& way, std::size_t i) {
  constexpr std::size_t kReach = 5;
  const Point2& from = way[i - std::min(i, kReach)];
  const Point2& to = way[std::min(i + kReach, way.size() - 1)];
  return {way[i].x(), way[i].y(), std::atan2(to.y() - from.y(), to.x() - from.x())};
}

}  // namespace

Explorer::Explorer(const SimulationOptions& options)
    : options_(options),
      limits_{options.speed_m_per_s / options.rate_hz,
              radians(options.turn_rate_deg_per_s) / options.rate_hz},
      map_(options.footprint),
      rooms_(map_.frame()) {}

std::optional<Steering> Explorer::decide(const RangeReading& reading, const Pose2& map_from_robot,
                                         bool bumped) {
  const Point2 position = map_from_robot.position();
  time_s_ += 1.0 / options_.rate_hz;
  if (last_step_ && !bumped) trace_.add(*last_step_);
  last_step_.reset();
  sense(reading, map_from_robot);
  echoes_.add(reading, map_from_robot);
  follow_rooms(map_from_robot);
  if (bumped || is_caught(map_from_robot)) get_away(bumped, position);
  if (const auto back = step_back(position)) return back;
  if (goal_ && !renew(*goal_, position)) goal_.reset();
  if (!goal_) goal_ = next_goal(position);
  if (!goal_ || is_stuck_) return std::nullopt;
  last_step_ = next_step(map_from_robot);
  return last_step_;
}

/// While it retreats: the next step of the way it came.
std::optional<Steering> Explorer::step_back(const Point2& position) {
  const double away_m = (position - caught_at_).norm();
  const bool can_turn = !map_.is_tight(map_.frame().cell_of(position));
  if (away_m > kRetreatM || (away_m > kLeastRetreatM && can_turn)) is_retreating_ = false;
  const auto back = is_retreating_ ? trace_.take_back() : std::nullopt;
  is_retreating_ = back.has_value();
  return back;
}

Steering Explorer::next_step(const Pose2& map_from_robot) {
  const std::vector<Point2> echoes_map = echoes_.points_map();
  if (time_s_ < shuffle_end_s_) {
    return shuffle(map_, echoes_map, map_from_robot, options_.footprint, shuffles_ % 2 == 1,
                   limits_);
  }
  return steer(map_, echoes_map, map_from_robot, options_.footprint, goal_->way, limits_);
}

/// Whether the robot has neither moved nor turned for a while: it is caught between its steps and
/// what it avoids.
bool Explorer::is_caught(const Pose2& map_from_robot) {
  const Pose2 moved = inverse(last_progress_) * map_from_robot;
  const bool is_getting_away = is_retreating_ || time_s_ < shuffle_end_s_;
  if (is_getting_away || moved.position().norm() > kProgressM ||
      std::abs(moved.theta_rad) > radians(kProgressDeg)) {
    last_progress_ = map_from_robot;
    progress_s_ = time_s_;
  }
  return time_s_ - progress_s_ >= kPatienceS;
}

/// A robot that is caught goes a little way straight back, the next time straight ahead. Caught
/// again and again in one place, or in contact, it goes back the way it came to where it can turn,
/// and leaves its goal.
void Explorer::get_away(bool bumped, const Point2& position) {
  progress_s_ = time_s_;
  if ((position - caught_at_).norm() > kCaughtM) caught_ = 0;
  caught_at_ = position;
  if (!bumped && ++caught_ <= kCalmShuffles) {
    shuffle_end_s_ = time_s_ + kShuffleS;
    ++shuffles_;
    return;
  }
  is_retreating_ = true;
  if (!goal_) return;
  if (bumped || !goal_->door || caught_ % kCalmShuffles == 0) give_up(*goal_, position);
  goal_.reset();
}

void Explorer::sense(const RangeReading& reading, const Pose2& map_from_robot) {
  if (last_mapped_) {
    const Pose2 moved = inverse(*last_mapped_) * map_from_robot;
    if (moved.position().norm() < kMapEveryM && std::abs(moved.theta_rad) < radians(kMapEveryDeg)) {
      return;
    }
  }
  last_mapped_ = map_from_robot;
  map_.add(reading, map_from_robot);
}

void Explorer::follow_rooms(const Pose2& map_from_robot) {
  const Point2 position = map_from_robot.position();
  const auto zone = rooms_.door_at(position);
  if (zone_ && zone != zone_) {
    const auto left = *zone_;
    zone_ = zone;
    rooms_.leave(left, position, [&] { return known_room_here(position); });
    if (goal_ && !goal_->door) goal_.reset();
  }
  zone_ = zone;
  if (!track_.empty() && (position - track_.back()).norm() < kMapEveryM) return;
  if ((position - last_moved_).norm() > kStuckM) {
    last_moved_ = position;
    given_up_here_ = 0;
  }
  if (track_.empty() || (position - track_.back()).norm() > kTrackEveryM) {
    track_.push_back(position);
    if (!zone_) look_behind(map_from_robot);
    if (!zone_ && track_.size() % kAnchorEvery == 1) rooms_.anchor(position);
  }
}

/// Doorways that were not seen ahead are found once the robot is through.
void Explorer::look_behind(const Pose2& map_from_robot) {
  const auto back = static_cast<std::size_t>(kLookBehindM / kTrackEveryM);
  if (track_.size() < back + 6) return;
  const Pose2 at = pose_on(track_, track_.size() - 1 - back);
  const auto doorway = seen_doorway(map_, at);
  if (!doorway) return;
  // The robot is beyond it already: the door belongs to the room where it was seen from.
  const auto doors = rooms_.doors().size();
  if (!rooms_.add(*doorway, at * kBefore)) return;
  const Point2 position = map_from_robot.position();
  rooms_.leave(doors, position, [&] { return known_room_here(position); });
  goal_.reset();
}

std::optional<ExplorerRooms::Room> Explorer::known_room_here(const Point2& position) {
  const auto nowhere = [](const Cell&) { return false; };
  (void)paths_.way(map_, position, nowhere,
                   [&](const Cell& cell) { return rooms_.is_closed(cell, std::nullopt); });
  for (ExplorerRooms::Room room = 0; room < rooms_.count(); ++room) {
    const auto& anchors = rooms_.anchors()[room];
    if (std::any_of(anchors.begin(), anchors.end(), [&](const Point2& anchor) {
          return paths_.reached(map_.frame().cell_of(anchor));
        })) {
      return room;
    }
  }
  return std::nullopt;
}

bool Explorer::is_wanted_frontier(const Cell& cell) const {
  return map_.is_frontier(cell) && !given_up_.contains(key_of(cell));
}

double Explorer::deadline_s(const Polyline& way) const {
  return time_s_ + 15.0 + 4.0 * length(way) / options_.speed_m_per_s;
}

/// When nothing is left, what was given up is tried once more: it may be clearer now.
std::optional<Explorer::Goal> Explorer::next_goal(const Point2& position) {
  auto goal = next_new_goal(position);
  if (goal || has_tried_again_) return goal;
  has_tried_again_ = true;
  given_up_.clear();
  rooms_.forget_failures();
  return next_new_goal(position);
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
    return Goal{{}, rooms_.current(), false, deadline_s(*way), std::move(*way)};
  }
}

/// A way that leaves through a doorway is no frontier of this room: the door is noted instead.
/// Doorways behind a known door of this room are another room's.
bool Explorer::find_doorway_on(const Polyline& way, const Point2& position) {
  for (std::size_t i = 0; i < way.size(); i += 2) {
    const auto known = rooms_.door_at(way[i]);
    if (known && rooms_.is_here(*known) && rooms_.beyond_m(*known, way[i]) > 0.0) return false;
    if (known || (way[i] - position).norm() < kDoorSkipM) continue;
    const Pose2 at = pose_on(way, i);
    const auto doorway = seen_doorway(map_, at);
    if (doorway && rooms_.add(*doorway, at * kBefore)) return true;
  }
  return false;
}

std::optional<Explorer::Goal> Explorer::door_goal(ExplorerRooms::Door door,
                                                  const Point2& position) {
  auto way = way_through(door, position);
  if (!way) return std::nullopt;
  return Goal{door, rooms_.current(), false, deadline_s(*way), std::move(*way)};
}

/// To behind a door; to its threshold where nothing behind has been seen.
std::optional<Polyline> Explorer::way_through(ExplorerRooms::Door door, const Point2& position) {
  const Doorway& doorway = rooms_.doors()[door].doorway;
  const auto is_in_line = [&](const Point2& at) {
    return std::abs((inverse(doorway.grid_from_pivot) * at).y()) <= doorway.width_m / 2.0;
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
  return Goal{{}, rooms_.current(), true, deadline_s(*way), std::move(*way)};
}

bool Explorer::is_done(const Goal& goal) const {
  if (goal.door) return !zone_ && rooms_.current() != goal.from;
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
  const Cell hopeless = map_.frame().cell_of(goal.way.back());
  const int reach = static_cast<int>(kGiveUpM / map_.frame().cell_m);
  for_each_cell(
      {{hopeless.x - reach, hopeless.y - reach}, {hopeless.x + reach + 1, hopeless.y + reach + 1}},
      [&](const Cell& cell) {
        if (distance_cells(cell, hopeless) <= reach) given_up_.insert(key_of(cell));
      });
}

}  // namespace roomatlas
