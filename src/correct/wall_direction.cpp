// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/correct/wall_direction.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace roomatlas {
namespace {

constexpr double kWindowRad = radians(6.0);  // walls this near follow a room's direction: wider
                                             // takes in curves, narrower loses what odometry bent
// Windows one after the other: the last ones settle on straight walls.
constexpr std::array kShrinkingDeg = {6.0, 3.0, 1.5, 1.5, 1.5};

struct Edge {
  double angle_rad = 0.0;
  double length_m = 0.0;
};

std::vector<Edge> edges_of(const std::vector<WallPolyline>& walls, double min_edge_m) {
  std::vector<Edge> edges;
  for (const WallPolyline& wall : walls) {
    for (std::size_t i = 1; i < wall.vertices_asr.size(); ++i) {
      const Point2 along = wall.vertices_asr[i] - wall.vertices_asr[i - 1];
      if (along.norm() < min_edge_m) continue;
      edges.push_back({std::atan2(along.y(), along.x()), along.norm()});
    }
  }
  return edges;
}

/// Length of wall within `window_rad` of an angle, and their length-weighted mean offset from it.
struct Support {
  double length_m = 0.0;
  double mean_offset_rad = 0.0;
};

Support support_of(const std::vector<Edge>& edges, double angle_rad, double window_rad) {
  Support support;
  for (const Edge& edge : edges) {
    const double offset = wrap_quarter(edge.angle_rad - angle_rad);
    if (std::abs(offset) > window_rad) continue;
    support.length_m += edge.length_m;
    support.mean_offset_rad += edge.length_m * offset;
  }
  if (support.length_m > 0.0) support.mean_offset_rad /= support.length_m;
  return support;
}

}  // namespace

double settled_direction(double about_rad, const std::vector<const Asr*>& rooms,
                         const std::vector<double>& heading_rad,
                         const WallDirectionOptions& options) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    for (const Edge& edge : edges_of(rooms[i]->walls, options.min_edge_m)) {
      edges.push_back({heading_rad[i] + edge.angle_rad, edge.length_m});
    }
  }
  for (const double window_deg : kShrinkingDeg) {
    about_rad += support_of(edges, about_rad, radians(window_deg)).mean_offset_rad;
  }
  return about_rad;
}

std::optional<WallDirection> wall_direction(const std::vector<WallPolyline>& walls,
                                            const WallDirectionOptions& options) {
  const std::vector<Edge> edges = edges_of(walls, options.min_edge_m);
  double total_m = 0.0;
  for (const Edge& edge : edges) total_m += edge.length_m;
  if (total_m < options.min_total_m) return std::nullopt;

  double best_angle = 0.0;
  Support best;
  for (int deg = 0; deg < 90; ++deg) {
    const Support support = support_of(edges, radians(deg), kWindowRad);
    if (support.length_m > best.length_m) {
      best = support;
      best_angle = radians(deg);
    }
  }
  for (int i = 0; i < 3; ++i) {  // settles on the mean of the edges around it
    best_angle += best.mean_offset_rad;
    best = support_of(edges, best_angle, kWindowRad);
  }
  const double share = best.length_m / total_m;
  if (share < options.min_aligned_share) return std::nullopt;
  double angle = wrap_quarter(best_angle);
  if (angle < 0.0) angle += kPi / 2.0;
  return WallDirection{angle >= kPi / 2.0 ? 0.0 : angle, share, best.length_m};
}

}  // namespace roomatlas
