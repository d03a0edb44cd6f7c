// SPDX-License-Identifier: GPL-3.0-or-later
#include "explorer.hpp"

#include "explorer_doorways.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr double kMapEveryM = 0.02;       // a sweep is mapped after this much motion ...
constexpr double kMapEveryDeg = 1.5;      // ... or turn; rarer: it meets what is not mapped yet
constexpr double kTrackEveryM = 0.05;     // between the points of the track
constexpr std::size_t kAnchorEvery = 10;  // of the track's points
constexpr double kLookBehindM = 0.6;      // both jambs have been seen by then
constexpr std::size_t kLeastBehind = 6;   // points behind that, so that the way has a direction
constexpr double kProgressM = 0.1;        // a robot that moved so far ...
constexpr double kProgressDeg = 15.0;     // ... or turned so much is not caught
constexpr double kPatienceS = 4.0;        // without progress: then it is. Less mistakes slow turns
constexpr double kShuffleS = 1.0;         // how long it goes back or ahead to get away
constexpr double kCaughtM = 0.5;          // so far away it is free again
constexpr int kCalmShuffles = 4;          // caught oftener in one place, it goes back
constexpr double kLeastRetreatM = 0.15;   // back at least so far, and to where it can turn
constexpr double kRetreatM = 1.0;         // at most

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
  if (track_.size() < back + kLeastBehind) return;
  const Pose2 at = pose_on_way(track_, track_.size() - 1 - back);
  const auto doorway = seen_doorway(map_, at);
  if (!doorway) return;
  // The robot is beyond it already: the door belongs to the room where it was seen from.
  const auto doors = rooms_.doors().size();
  if (!rooms_.add(*doorway, a_metre_before(at))) return;
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

}  // namespace roomatlas
