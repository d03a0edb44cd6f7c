// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/match/room_localizer.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr int kAtOnce = 4;           // sweeps of a room entered that are drawn while one is matched
constexpr double kFade = 0.5;        // of recent turns, at each reading
constexpr double kMaxLostM = 1.5;    // a wide search goes no farther
constexpr double kLostSigmaM = 0.1;  // of a pose that a wide search found
constexpr double kLostSigmaRad = radians(2.0);  // ... and of its heading

}  // namespace

bool can_be_matched(const RangeReading& reading) {
  return reading.sensor->kind == SensorKind::laser;
}

bool is_new_view(const Pose2& from, const Pose2& to, const LocalizeOptions& options,
                 bool has_few_beams) {
  const Pose2 moved = inverse(from) * to;
  const double every_m = has_few_beams ? options.insert_few_every_m : options.insert_every_m;
  const double every_deg = has_few_beams ? options.insert_few_every_deg : options.insert_every_deg;
  return moved.position().norm() > every_m || std::abs(moved.theta_rad) > radians(every_deg);
}

/// True when nearly every point found its wall, and near to where odometry had it.
bool RoomLocalizer::is_at_ease(const ScanAlignment& aligned, const PosePrior& prior) const {
  const Pose2 moved = inverse(prior.mean) * aligned.map_from_points;
  return aligned.matched > min_matched() &&
         aligned.matched > options_.ease_share * aligned.points &&
         moved.position().norm() < options_.ease_sigmas * prior.position_sigma_m &&
         std::abs(moved.theta_rad) < options_.ease_sigmas * prior.heading_sigma_rad;
}

/// Where odometry told nothing of a motion: the room itself says where the robot is.
ScanAlignment RoomLocalizer::search_wide(const std::vector<ScanPoint>& points,
                                         const Pose2& predicted, double step_m,
                                         double turned_rad) const {
  CorrelateOptions window = options_.lost;
  window.reach_m = std::min(kMaxLostM, window.reach_m + 2.0 * step_m);  // it may have been back
  window.reach_rad += options_.search_per_turn / 2.0 * turned_rad;
  PosePrior anywhere{predicted, window.reach_m, window.reach_rad};
  anywhere.mean = correlate(map_, points, anywhere, window);
  const Pose2 start = correlate(map_, points, anywhere, options_.correlate);
  return align(map_, points, start, PosePrior{start, kLostSigmaM, kLostSigmaRad}, options_.align);
}

/// Whether walls across the robot's way were seen, which tell how far it went.
bool RoomLocalizer::is_length_seen(const ScanAlignment& aligned) const {
  const Point2 ahead = direction(aligned.map_from_points.theta_rad);
  const double across = ahead.dot(aligned.hessian.topLeftCorner<2, 2>() * ahead);
  return across > (has_few_ ? options_.min_across_of_few : options_.min_across);
}

void RoomLocalizer::clear() {
  learnt_.habits.interrupt();
  map_ = LocalMap(options_.cell_m);
  waiting_.clear();
  before_.clear();
  moving_.clear();
  recent_.clear();
  last_added_.reset();
  recent_turn_rad_ = 0.0;
}

std::optional<OdometryHabits> RoomLocalizer::habits() const {
  if (learnt_.habits.stretches() == 0) return std::nullopt;
  OdometryHabits habits = learnt_.habits.habits();
  habits.lag_s = learnt_.lag.lag_s();
  return habits;
}

bool RoomLocalizer::is_worth_adding(const Pose2& map_from_robot) const {
  return !last_added_ || is_new_view(*last_added_, map_from_robot, options_, has_few_);
}

void RoomLocalizer::insert(const Scan& scan, const Pose2& map_from_robot) {
  last_added_ = map_from_robot;
  map_.add(scan, map_from_robot);
}

void RoomLocalizer::add(const RangeReading& reading, const Pose2& asr_from_robot) {
  if (!can_be_matched(reading)) return;
  if (before_.empty() ||
      reading.timestamp_s >= before_.back().first.timestamp_s + options_.moving.apart_s) {
    before_.emplace_back(reading, asr_from_robot);
    if (before_.size() > static_cast<std::size_t>(options_.moving.kept)) before_.pop_front();
  }
  has_few_ = recent_.are_needed(*reading.sensor);
  if (!is_worth_adding(asr_from_robot)) return;
  if (has_few_) {
    Scan scan = scan_of(reading, options_.scan);
    recent_.add_normals(scan, asr_from_robot);
    recent_.add(scan, asr_from_robot);
    insert(scan, asr_from_robot);
    return;
  }
  last_added_ = asr_from_robot;
  waiting_.emplace_back(reading, asr_from_robot);
}

void RoomLocalizer::insert_some_waiting() {
  for (int i = 0; i < kAtOnce && !waiting_.empty(); ++i) {
    const auto& [reading, map_from_robot] = waiting_.back();
    map_.add(scan_of(reading, options_.scan), map_from_robot);
    waiting_.pop_back();
  }
}

/// Takes what moves out of a sweep. The first of a room is compared with those at its door.
bool RoomLocalizer::hide_moving(Scan& scan, const RangeReading& reading,
                                const Pose2& map_from_robot) {
  for (const auto& [seen, pose] : std::exchange(before_, {})) {
    Scan at_door = scan_of(seen, options_.scan);
    moving_.hide(at_door, seen.timestamp_s, seen.odom_from_robot, pose);
  }
  return moving_.hide(scan, reading.timestamp_s, reading.odom_from_robot, map_from_robot) > 0;
}

ScanAlignment RoomLocalizer::match(const std::vector<ScanPoint>& points, const Pose2& predicted,
                                   const Pose2& step) const {
  const double step_m = step.position().norm();
  const double turned_rad = std::max(std::abs(step.theta_rad), kFade * recent_turn_rad_);
  const OdometryNoise& odometry = options_.odometry;
  const PosePrior prior{predicted, plain_sum(odometry.position, step_m, turned_rad),
                        plain_sum(odometry.heading, step_m, turned_rad)};
  ScanAlignment aligned = align(map_, points, predicted, prior, options_.align);
  if (!is_at_ease(aligned, prior)) {  // odometry may have jumped: search around it
    PosePrior wide = prior;
    wide.position_sigma_m *= 2.0;
    wide.heading_sigma_rad *= 2.0;
    CorrelateOptions window = options_.correlate;
    window.reach_rad += options_.search_per_turn * turned_rad;
    const Pose2 start = correlate(map_, points, wide, window);
    aligned = align(map_, points, start, prior, options_.align);
  }
  if (aligned.matched >= options_.lost_share * aligned.points) return aligned;
  const ScanAlignment found = search_wide(points, predicted, step_m, turned_rad);
  const double more = static_cast<double>(found.matched - aligned.matched);
  const bool is_there = found.matched > options_.found_share * found.points &&
                        more > options_.found_more_share * found.points;
  return is_there ? found : aligned;
}

Pose2 RoomLocalizer::locate(const RangeReading& reading, const Pose2& predicted_asr_from_robot,
                            const Pose2& step) {
  recent_turn_rad_ = kFade * recent_turn_rad_ + std::abs(step.theta_rad);
  if (!can_be_matched(reading)) return predicted_asr_from_robot;
  insert_some_waiting();
  has_few_ = recent_.are_needed(*reading.sensor);
  Scan scan = scan_of(reading, options_.scan);
  const Pose2 before = predicted_asr_from_robot * inverse(step);
  Pose2 pose = before * without_habits(step, learnt_.habits.habits());
  if (has_few_) recent_.add_normals(scan, pose);
  if (map_.empty()) {
    hide_moving(scan, reading, pose);
  } else {
    ScanAlignment aligned = match(thinned(scan.points, options_.max_points), pose, step);
    if (hide_moving(scan, reading, aligned.map_from_points)) {
      aligned = match(thinned(scan.points, options_.max_points), pose, step);
    }
    if (aligned.matched > min_matched() &&
        aligned.matched > options_.min_matched_share * aligned.points) {
      pose = aligned.map_from_points;
      const Pose2 matched = inverse(before) * pose;
      learnt_.habits.add(step, matched, is_length_seen(aligned));
      learnt_.lag.add(reading.timestamp_s, reading.odom_from_robot.theta_rad, matched.theta_rad);
    } else {
      learnt_.habits.interrupt();
      learnt_.lag.interrupt();
    }
  }
  if (has_few_) recent_.add(scan, pose);
  if (is_worth_adding(pose)) insert(scan, pose);
  return pose;
}

}  // namespace roomatlas
