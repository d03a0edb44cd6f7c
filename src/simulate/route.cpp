// SPDX-License-Identifier: GPL-3.0-or-later
#include "route.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

Pose2 pose_at(const Motion& motion, double time_s) {
  const double share = std::clamp((time_s - motion.start_s) / motion.duration_s, 0.0, 1.0);
  return motion.world_from_start * Pose2{share * motion.length_m, 0.0, share * motion.turn_rad};
}

double end_s(const Motion& motion) { return motion.start_s + motion.duration_s; }

/// The part of a motion inside a time span; its duration is not positive where there is none.
Motion clipped(const Motion& motion, double from_s, double to_s) {
  const double begin_s = std::max(from_s, motion.start_s);
  const double span_s = std::min(to_s, end_s(motion)) - begin_s;
  const double share = span_s / motion.duration_s;
  return {begin_s, span_s, pose_at(motion, begin_s), share * motion.length_m,
          share * motion.turn_rad};
}

}  // namespace

Route route_along(const std::vector<Leg>& legs, const SimulationOptions& options) {
  const double turn_rate_rad_per_s = radians(options.turn_rate_deg_per_s);
  Route route;
  double now_s = 0.0;
  double heading_rad = 0.0;
  for (const Leg& leg : legs) {
    const Point2 along = leg.line.b - leg.line.a;
    const double leg_heading_rad = std::atan2(along.y(), along.x());
    const double turn_rad = wrap_angle(leg_heading_rad - heading_rad);
    if (!route.empty() && turn_rad != 0.0) {
      const Pose2 start{leg.line.a.x(), leg.line.a.y(), heading_rad};
      route.push_back({now_s, std::abs(turn_rad) / turn_rate_rad_per_s, start, 0.0, turn_rad});
      now_s = end_s(route.back());
    }
    heading_rad = wrap_angle(leg_heading_rad);
    const Pose2 start{leg.line.a.x(), leg.line.a.y(), heading_rad};
    const double length_m = along.norm();
    route.push_back({now_s, length_m / options.speed_m_per_s, start, length_m, 0.0});
    now_s = end_s(route.back());
  }
  return route;
}

Route way_back(const Pose2& world_from_robot, const Pose2& world_from_goal,
               const SimulationOptions& options) {
  const double turn_rate_rad_per_s = radians(options.turn_rate_deg_per_s);
  const Point2 along = world_from_goal.position() - world_from_robot.position();
  const double length_m = along.norm();
  const double way_rad =
      length_m > 0.0 ? std::atan2(along.y(), along.x()) : world_from_robot.theta_rad;
  Route route;
  Pose2 pose = world_from_robot;
  double now_s = 0.0;
  const auto add = [&](double duration_s, double driven_m, double turn_rad) {
    if (duration_s <= 0.0) return;
    route.push_back({now_s, duration_s, pose, driven_m, turn_rad});
    pose = pose * Pose2{driven_m, 0.0, turn_rad};
    now_s = end_s(route.back());
  };
  const auto turn_to = [&](double heading_rad) {
    const double turn_rad = wrap_angle(heading_rad - pose.theta_rad);
    add(std::abs(turn_rad) / turn_rate_rad_per_s, 0.0, turn_rad);
  };
  turn_to(way_rad);
  add(length_m / options.speed_m_per_s, length_m, 0.0);
  turn_to(world_from_goal.theta_rad);
  return route;
}

double duration_s(const Route& route) { return route.empty() ? 0.0 : end_s(route.back()); }

Pose2 world_from_robot_at(const Route& route, double time_s) {
  const auto motion = std::find_if(route.begin(), std::prev(route.end()),
                                   [&](const Motion& m) { return time_s < end_s(m); });
  return pose_at(*motion, time_s);
}

std::vector<Motion> motions_between(const Route& route, double from_s, double to_s) {
  std::vector<Motion> motions;
  for (const Motion& motion : route) {
    if (motion.start_s >= to_s) break;
    const Motion part = clipped(motion, from_s, to_s);
    if (part.duration_s > 0.0) motions.push_back(part);
  }
  return motions;
}

}  // namespace roomatlas
