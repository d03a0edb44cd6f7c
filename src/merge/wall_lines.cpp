// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace roomatlas {
namespace {

constexpr double kSameLine_m = 1e-6;       // offsets on one line differ by roundings alone
constexpr double kLeastCornerSine = 0.34;  // lines that meet under 20 degrees make no corner
// Of the greatest distance: the nearest lines join first, so that a far one cannot take them apart.
constexpr std::array kJoinShares = {0.25, 0.5, 1.0};

/// Edges on one line, or about to be.
struct Group {
  std::vector<std::size_t> edges;
  double weight_m = 0.0;
  double offset_m = 0.0;  ///< mean, by length
  double from_m = 0.0;    ///< extent along the direction
  double to_m = 0.0;
  double least_m = 0.0;  ///< offsets that are near enough to all edges
  double most_m = 0.0;
};

Group group_of(std::size_t index, const RegularEdge& edge, double max_distance_m) {
  const auto [from, to] =
      std::minmax({edge.line.along.dot(edge.evidence.a), edge.line.along.dot(edge.evidence.b)});
  const auto [low, high] = std::minmax(
      {edge.line.normal().dot(edge.evidence.a), edge.line.normal().dot(edge.evidence.b)});
  return {{index}, edge.length_m(),       edge.line.offset_m,  from,
          to,      high - max_distance_m, low + max_distance_m};
}

/// Adds `other` to the group, if all edges of both may lie on the common mean.
bool join(Group& group, const Group& other, double max_gap_m) {
  const double gap = std::max(group.from_m, other.from_m) - std::min(group.to_m, other.to_m);
  const double weight = group.weight_m + other.weight_m;
  const double offset =
      (group.offset_m * group.weight_m + other.offset_m * other.weight_m) / weight;
  const double least = std::max(group.least_m, other.least_m);
  const double most = std::min(group.most_m, other.most_m);
  if (gap > max_gap_m || offset < least || offset > most) return false;
  group.edges.insert(group.edges.end(), other.edges.begin(), other.edges.end());
  group = {std::move(group.edges),           weight, offset, std::min(group.from_m, other.from_m),
           std::max(group.to_m, other.to_m), least,  most};
  return true;
}

/// Joins groups with those of near offsets, the nearest first.
void join_groups(std::vector<Group>& groups, double max_distance_m, double max_gap_m) {
  for (const double share : kJoinShares) {
    std::sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
      return a.offset_m != b.offset_m ? a.offset_m < b.offset_m : a.edges < b.edges;
    });
    for (std::size_t i = 0; i < groups.size(); ++i) {
      if (groups[i].edges.empty()) continue;
      for (std::size_t j = i + 1; j < groups.size(); ++j) {
        if (groups[j].offset_m - groups[i].offset_m > share * max_distance_m) break;
        if (groups[j].edges.empty() || !join(groups[i], groups[j], max_gap_m)) continue;
        groups[j].edges.clear();
        j = i;  // the joined group reaches farther
      }
    }
    std::erase_if(groups, [](const Group& group) { return group.edges.empty(); });
  }
}

bool is_same(const WallLine& a, const WallLine& b) {
  return a.along == b.along && std::abs(a.offset_m - b.offset_m) < kSameLine_m;
}

std::optional<Point2> corner_of(const WallLine& a, const WallLine& b) {
  const double sine = cross(a.along, b.along);
  if (std::abs(sine) < kLeastCornerSine) return std::nullopt;
  const Point2 on_a = a.offset_m * a.normal();
  return on_a + a.along * (b.offset_m - b.normal().dot(on_a)) / b.normal().dot(a.along);
}

WallLine line_of(const Point2& from, const Point2& to) {
  WallLine line{(to - from).normalized(), 0.0};
  line.offset_m = line.normal().dot(from);
  return line;
}

}  // namespace

std::optional<RegularEdge> regular_edge(const Point2& a, const Point2& b,
                                        const std::vector<double>& directions_rad,
                                        const RegularWallOptions& options) {
  if ((b - a).norm() < options.min_wall_m) return std::nullopt;
  const double heading = std::atan2(b.y() - a.y(), b.x() - a.x());
  for (std::size_t d = 0; d < directions_rad.size(); ++d) {
    const double off = quarter_difference(heading, directions_rad[d]);
    if (std::abs(off) > radians(options.max_turn_deg)) continue;
    const double quarters = std::round((heading - off - directions_rad[d]) / kQuarter_rad);
    const int quarter = (static_cast<int>(quarters) % 4 + 4) % 4;
    RegularEdge edge{{a, b}, {}, static_cast<int>(d) * 4 + quarter};
    edge.line.along = direction(directions_rad[d] + quarter * kQuarter_rad);
    edge.line.offset_m = edge.line.normal().dot((a + b) / 2.0);
    if (edge.line.distance(a) > options.max_distance_m) return std::nullopt;
    return edge;
  }
  return std::nullopt;
}

double quarter_angle(const Point2& along) {
  const double angle = std::fmod(std::atan2(along.y(), along.x()) + 2.0 * kPi, kQuarter_rad);
  return angle < kQuarter_rad ? angle : 0.0;
}

double quarter_difference(double a_rad, double b_rad) {
  return std::remainder(a_rad - b_rad, kQuarter_rad);
}

void align(std::vector<RegularEdge>& edges, double max_distance_m, double max_gap_m) {
  std::map<int, std::vector<Group>> by_direction;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    by_direction[edges[e].direction].push_back(group_of(e, edges[e], max_distance_m));
  }
  for (auto& [direction, groups] : by_direction) {
    join_groups(groups, max_distance_m, max_gap_m);
    for (const Group& group : groups) {
      for (const std::size_t e : group.edges) edges[e].line.offset_m = group.offset_m;
    }
  }
}

Ring ring_on_lines(const Ring& ring, const std::vector<const WallLine*>& lines, double max_move_m) {
  Ring moved;
  const std::size_t count = ring.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point2& vertex = ring[i];
    const std::size_t before = (i + count - 1) % count;
    const WallLine* in = lines[before];
    const WallLine* out = lines[i];
    if (in == nullptr && out == nullptr) {
      moved.push_back(vertex);
      continue;
    }
    if (in != nullptr && out != nullptr && is_same(*in, *out)) continue;  // the wall goes on
    const WallLine own_in = in != nullptr ? *in : line_of(ring[before], vertex);
    const WallLine own_out = out != nullptr ? *out : line_of(vertex, ring[(i + 1) % count]);
    const auto corner = corner_of(own_in, own_out);
    if (corner && (*corner - vertex).norm() <= max_move_m) {
      moved.push_back(*corner);
      continue;
    }
    if (in != nullptr) moved.push_back(in->foot(vertex));
    if (in == nullptr || out == nullptr) moved.push_back(vertex);
    if (out != nullptr) moved.push_back(out->foot(vertex));
  }
  return moved.size() < 3 ? ring : moved;
}

}  // namespace roomatlas
