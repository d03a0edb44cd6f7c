// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/merge/regular_walls.hpp"

#include "blind_corners.hpp"
#include "regular_doors.hpp"
#include "ring_edges.hpp"
#include "roomatlas/planar/heal.hpp"
#include "roomatlas/planar/simplify.hpp"
#include "roomatlas/planar/union.hpp"
#include "wall_lines.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace roomatlas {
namespace {

constexpr double kMoveOverDistance = 1.5;  // of a corner, whose two walls both moved
constexpr double kMaxAreaChange = 0.1;     // share of a ring's area; more is no straightening
// A curve's chords turn by more than noise, and by no more than an octagon's sides. A wider range
// leaves rough walls as they are, a narrower one makes stairs of curves.
constexpr double kLeastCurveRad = radians(4.0);
constexpr double kMostCurveRad = radians(46.0);
// Edges at least this long move, in turn: the fewer, the less a ring crosses itself.
constexpr std::array kLeastMovedM = {0.0, 1.0, 2.0};

/// Whether the ring turns a little, the same way, at both ends of the edge: then it is part of a
/// curve.
bool is_in_curve(const Ring& ring, std::size_t edge) {
  const std::size_t count = ring.size();
  const auto along = [&](std::size_t i) { return Point2(ring[(i + 1) % count] - ring[i % count]); };
  const auto turn = [&](const Point2& in, const Point2& out) {
    return std::atan2(cross(in, out), in.dot(out));
  };
  const double before = turn(along(edge + count - 1), along(edge));
  const double after = turn(along(edge), along(edge + 1));
  const auto is_slight = [](double angle) {
    return std::abs(angle) > kLeastCurveRad && std::abs(angle) < kMostCurveRad;
  };
  return before * after > 0.0 && is_slight(before) && is_slight(after);
}

/// Whether the vertices between two may go: the wall from one to the other is regular, and they are
/// near it.
bool is_one_wall(const Ring& ring, std::size_t from, std::size_t to,
                 const std::vector<double>& directions, const RegularWallOptions& options) {
  const std::size_t count = ring.size();
  const auto edge = regular_edge(ring[from % count], ring[to % count], directions, options);
  if (!edge) return false;
  for (std::size_t i = from; i < to; ++i) {
    if (is_in_curve(ring, i % count)) return false;
    if (edge->line.distance(ring[i % count]) > options.max_distance_m) return false;
  }
  return true;
}

/// The ring without the vertices that make a regular wall rough.
Ring straightened(const Ring& ring, const std::vector<double>& directions,
                  const RegularWallOptions& options) {
  const std::vector<std::size_t> corners =
      planar::corners_of(ring, options.roughness * options.max_distance_m);
  Ring straight;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const std::size_t from = corners[c];
    const std::size_t to = c + 1 < corners.size() ? corners[c + 1] : corners[0] + ring.size();
    straight.push_back(ring[from]);
    if (is_one_wall(ring, from, to, directions, options)) continue;
    for (std::size_t i = from + 1; i < to; ++i) straight.push_back(ring[i % ring.size()]);
  }
  return straight;
}

/// Which edges of a ring follow a direction: their numbers in a common list, or -1.
using EdgeNumbers = std::vector<int>;

EdgeNumbers regular_edges(const Ring& ring, const std::vector<double>& directions,
                          const RegularWallOptions& options, std::vector<RegularEdge>& edges) {
  EdgeNumbers numbers(ring.size(), -1);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (is_in_curve(ring, i)) continue;
    const auto edge = regular_edge(ring[i], ring[(i + 1) % ring.size()], directions, options);
    if (!edge) continue;
    numbers[i] = static_cast<int>(edges.size());
    edges.push_back(*edge);
  }
  return numbers;
}

/// Steps between walls on one line that are shorter than a wall: the line goes on over them.
void bridge_steps(const Ring& ring, EdgeNumbers& numbers, const std::vector<RegularEdge>& edges,
                  const RegularWallOptions& options) {
  const std::size_t count = ring.size();
  const EdgeNumbers found = numbers;
  for (std::size_t i = 0; i < count; ++i) {
    const int before = found[(i + count - 1) % count];
    const int after = found[(i + 1) % count];
    if (found[i] >= 0 || before < 0 || after < 0) continue;
    const WallLine& line = edges[static_cast<std::size_t>(before)].line;
    const WallLine& next = edges[static_cast<std::size_t>(after)].line;
    const bool is_one_line = line.along == next.along && line.offset_m == next.offset_m;
    const bool is_near = line.distance(ring[i]) <= options.max_distance_m &&
                         line.distance(ring[(i + 1) % count]) <= options.max_distance_m;
    if (is_one_line && is_near) numbers[i] = before;
  }
}

Ring regular_ring(const Ring& ring, EdgeNumbers numbers, const std::vector<RegularEdge>& edges,
                  const RegularWallOptions& options) {
  bridge_steps(ring, numbers, edges, options);
  std::vector<const WallLine*> lines;
  for (const int number : numbers) {
    lines.push_back(number < 0 ? nullptr : &edges[static_cast<std::size_t>(number)].line);
  }
  return ring_on_lines(ring, lines, kMoveOverDistance * options.max_distance_m);
}

/// The outline without crossings, spikes and repeated vertices; as it is where that leaves parts.
Polygon healed(const Polygon& outline) {
  constexpr double kCrumb_m2 = 0.1;  // parts this small may be lost; larger ones may not
  if (planar::is_simple(outline)) return outline;
  std::vector<Polygon> parts = union_of({outline});
  if (parts.empty()) return outline;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (area(parts[i]) > kCrumb_m2) return outline;
  }
  return std::move(parts.front());
}

bool is_acceptable(const Polygon& before, const Polygon& after) {
  const double change = std::abs(signed_area(after.outer) - signed_area(before.outer));
  return planar::is_simple(after) && change <= kMaxAreaChange * std::abs(signed_area(before.outer));
}

/// The outline with its regular edges on their lines: all of them, else the long ones alone, as few
/// as it takes for it not to cross itself.
std::optional<Polygon> regular_outline(const Polygon& outline, std::vector<EdgeNumbers> numbers,
                                       const std::vector<RegularEdge>& edges,
                                       const RegularWallOptions& options) {
  for (const double least_m : kLeastMovedM) {
    for (EdgeNumbers& of_ring : numbers) {
      for (int& edge : of_ring) {
        if (edge >= 0 && edges[static_cast<std::size_t>(edge)].length_m() < least_m) edge = -1;
      }
    }
    Polygon moved{regular_ring(outline.outer, numbers.front(), edges, options), {}};
    for (std::size_t h = 0; h < outline.holes.size(); ++h) {
      moved.holes.push_back(regular_ring(outline.holes[h], numbers[h + 1], edges, options));
    }
    if (is_acceptable(outline, moved)) return moved;
  }
  return std::nullopt;
}

}  // namespace

RegularOutlines with_regular_walls(std::vector<PlacedOutline> outlines,
                                   const std::vector<Door>& doors,
                                   const RegularWallOptions& options) {
  RegularOutlines result;
  for (PlacedOutline& placed : outlines) placed.outline = healed(placed.outline);
  result.directions_rad = building_directions(outlines, options);
  result.doors = doors;
  const RingsOfRooms rings = rings_of(outlines);
  for (Door& door : result.doors) {
    turn_into_wall(door, rings, result.directions_rad, options);
  }
  for (const auto& [room, of_room] : rings) {
    for (Ring* ring : of_room) {
      *ring = straightened(*ring, result.directions_rad, options);
      Polygon closed{with_closed_corners(*ring, result.doors, result.directions_rad, options), {}};
      if (planar::is_simple(closed)) *ring = std::move(closed.outer);
    }
  }
  std::vector<RegularEdge> edges;
  std::vector<EdgeNumbers> numbers;
  for_each_ring(outlines, [&](const Ring& ring) {
    numbers.push_back(regular_edges(ring, result.directions_rad, options, edges));
    for_each_edge(ring, [&](const Point2& a, const Point2& b) { result.wall_m += (b - a).norm(); });
  });
  for (const RegularEdge& edge : edges) result.regular_m += edge.length_m();
  align(edges, options.max_distance_m, options.align_gap_m);
  auto of_outline = numbers.begin();
  for (PlacedOutline& placed : outlines) {
    const auto past = of_outline + 1 + static_cast<std::ptrdiff_t>(placed.outline.holes.size());
    const auto moved = regular_outline(placed.outline, {of_outline, past}, edges, options);
    of_outline = past;
    if (moved) {
      placed.outline = *moved;
    } else {
      ++result.kept;
    }
    result.outlines.push_back(std::move(placed));
  }
  return result;
}

}  // namespace roomatlas
