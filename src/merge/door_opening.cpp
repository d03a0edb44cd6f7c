// SPDX-License-Identifier: GPL-3.0-or-later
#include "door_opening.hpp"

#include "roomatlas/core/median.hpp"
#include "roomatlas/planar/millimetre_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace roomatlas::planar {
namespace {

constexpr double kReach_mm = 600.0;           // across the door line: floor farther off is not the
                                              // door's; less loses floor behind a thick wall
constexpr double kMaxAside_mm = 240.0;        // lines beside the door, from its jambs
constexpr double kSliver_mm = 20.0;           // narrower floor is none
constexpr double kNotch_mm = 150.0;           // one line may reach this much deeper than the middle
constexpr double kMaxBesideDepth_mm = 600.0;  // a wall beside the door is not thicker
constexpr double kSlack_mm = 1.0;             // lines at the rim miss no edge by a rounding
constexpr std::array kAcross = {0.1, 0.3, 0.5, 0.7, 0.9};  // of the door's width: lines that tell
                                                           // how deep it is, none at a jamb

/// The stretch without floor across the door line, as offsets along the normal.
struct Gap {
  double low_mm = 0.0;
  double high_mm = 0.0;
  int room_low = -1;   ///< the floor below `low_mm`; -1: none within reach
  int room_high = -1;  ///< the floor above `high_mm`
};

/// A stretch of one room's floor.
struct Stretch {
  double low_mm = 0.0;
  double high_mm = 0.0;
  int room = -1;  ///< its position among the rooms
};

/// An edge of an outline near the door.
struct NearEdge {
  Segment2 edge;
  int shape = 0;
};

/// A line across the door, and the edges that it may meet.
struct Probe {
  const FloorLookup& floors;
  const std::vector<NearEdge>& edges;  ///< by ascending shape
  Point2 base;
  Point2 normal;
};

/// All edges of near outlines that lines across the door may meet, however far away: where a line
/// is inside or outside of an outline follows from all that it meets.
std::vector<NearEdge> edges_across(const FloorLookup& floors, const Segment2& jambs_mm) {
  const Point2 unit = (jambs_mm.b - jambs_mm.a).normalized();
  const double low = -kMaxAside_mm - kSlack_mm;
  const double high = (jambs_mm.b - jambs_mm.a).norm() + kMaxAside_mm + kSlack_mm;
  Box2 box;
  for (const Point2& jamb : {jambs_mm.a, jambs_mm.b}) {
    box.extend(jamb + Point2::Constant(kReach_mm));
    box.extend(jamb - Point2::Constant(kReach_mm));
  }
  std::vector<NearEdge> found;
  const auto add = [&](const Ring& ring, int shape) {
    double from = ring.empty() ? 0.0 : unit.dot(ring.back() - jambs_mm.a);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const double to = unit.dot(ring[i] - jambs_mm.a);
      if (std::min(from, to) <= high && std::max(from, to) >= low) {
        found.push_back({{ring[i == 0 ? ring.size() - 1 : i - 1], ring[i]}, shape});
      }
      from = to;
    }
  };
  for (const int shape : floors.shapes.near(box)) {
    const Polygon& polygon = floors.outlines.shapes_mm[static_cast<std::size_t>(shape)];
    add(polygon.outer, shape);
    for (const Ring& hole : polygon.holes) add(hole, shape);
  }
  return found;
}

/// A point on the line from which on an outline does, or does not, cover it.
struct Turn {
  double at_mm = 0.0;
  int shape = 0;
};

std::vector<Turn> turns_along(const Probe& probe) {
  std::vector<Turn> turns;
  for (const NearEdge& near : probe.edges) {
    const double from = cross(probe.normal, near.edge.a - probe.base);
    const double to = cross(probe.normal, near.edge.b - probe.base);
    if ((from >= 0.0) == (to >= 0.0)) continue;
    const Point2 at = near.edge.a + (near.edge.b - near.edge.a) * (from / (from - to));
    const double offset = probe.normal.dot(at - probe.base);
    turns.push_back({std::clamp(offset, -kReach_mm, kReach_mm), near.shape});
  }
  std::sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) {
    return a.at_mm != b.at_mm ? a.at_mm < b.at_mm : a.shape < b.shape;
  });
  return turns;
}

/// The floor along the line, room by room.
std::vector<Stretch> floor_along(const Probe& probe) {
  std::vector<Stretch> floor;
  std::vector<int> covering;
  const std::vector<Turn> turns = turns_along(probe);
  for (std::size_t i = 0; i + 1 < turns.size(); ++i) {
    const auto at = std::lower_bound(covering.begin(), covering.end(), turns[i].shape);
    if (at != covering.end() && *at == turns[i].shape) {
      covering.erase(at);
    } else {
      covering.insert(at, turns[i].shape);
    }
    if (turns[i + 1].at_mm <= turns[i].at_mm) continue;
    const int room = owner(covering, probe.floors.outlines.room_of_shape, probe.floors.room_mm2);
    if (room < 0) continue;
    const bool continues =
        !floor.empty() && floor.back().room == room && floor.back().high_mm == turns[i].at_mm;
    if (!continues) floor.push_back({turns[i].at_mm, 0.0, room});
    floor.back().high_mm = turns[i + 1].at_mm;
  }
  std::erase_if(floor, [](const Stretch& s) {
    const bool is_cut_off = s.low_mm <= -kReach_mm || s.high_mm >= kReach_mm;
    return !is_cut_off && s.high_mm - s.low_mm < kSliver_mm;
  });
  return floor;
}

/// All gaps along the line, and borders where one room's floor touches another's.
std::vector<Gap> gaps_along(const Probe& probe) {
  std::vector<Gap> gaps;
  Gap gap{-kReach_mm, kReach_mm, -1, -1};
  for (const Stretch& floor : floor_along(probe)) {
    gap.high_mm = floor.low_mm;
    gap.room_high = floor.room;
    const bool is_border = gap.high_mm == gap.low_mm && gap.room_low >= 0;
    if (gap.high_mm > gap.low_mm || (is_border && gap.room_low != gap.room_high)) {
      gaps.push_back(gap);
    }
    gap = {floor.high_mm, kReach_mm, floor.room, -1};
  }
  if (gap.high_mm > gap.low_mm) gaps.push_back(gap);
  return gaps;
}

/// The gap at the door line: the right rooms first, then the nearest.
std::optional<Gap> gap_at_door(const Probe& probe, int first, int second) {
  std::optional<Gap> best;
  double best_cost = 0.0;
  for (const Gap& gap : gaps_along(probe)) {
    const auto joins = [&](int a, int b) {
      return (a < 0 || gap.room_low == a) && (b < 0 || gap.room_high == b);
    };
    const bool is_right = joins(first, second) || joins(second, first);
    const double distance = std::max({0.0, gap.low_mm, -gap.high_mm});
    const double cost = distance + (is_right ? 0.0 : 2.0 * kReach_mm);
    if (best && cost >= best_cost) continue;
    best = gap;
    best_cost = cost;
  }
  return best;
}

/// Offsets at which floor ends, one entry a line that met floor.
struct Ends {
  std::vector<double> low_mm;
  std::vector<double> high_mm;
};

/// The deepest of the lines, but not much deeper than the middle one: a notch is no doorway.
std::optional<double> lowest(const std::vector<double>& ends) {
  if (ends.empty()) return std::nullopt;
  return std::max(*std::min_element(ends.begin(), ends.end()), median(ends) - kNotch_mm);
}

std::optional<double> highest(const std::vector<double>& ends) {
  if (ends.empty()) return std::nullopt;
  return std::min(*std::max_element(ends.begin(), ends.end()), median(ends) + kNotch_mm);
}

void add(const std::optional<Gap>& gap, Ends& ends) {
  if (!gap) return;
  if (gap->room_low >= 0) ends.low_mm.push_back(gap->low_mm);
  if (gap->room_high >= 0) ends.high_mm.push_back(gap->high_mm);
}

struct Depth {
  double low_mm = 0.0;
  double high_mm = 0.0;
};

Depth depth_of(const Ends& between, const Ends& beside, double wall_thickness_mm) {
  auto low = lowest(between.low_mm);
  auto high = highest(between.high_mm);
  if (low && high && !beside.low_mm.empty()) {
    low = std::min(*low, median(beside.low_mm));
    high = std::max(*high, median(beside.high_mm));
  }
  if (!low && !high) return {-wall_thickness_mm / 2.0, wall_thickness_mm / 2.0};
  if (!low) low = std::min(*high - wall_thickness_mm, 0.0);
  if (!high) high = std::max(*low + wall_thickness_mm, 0.0);
  if (*high - *low < wall_thickness_mm / 2.0) {
    const double middle = (*low + *high) / 2.0;
    return {middle - wall_thickness_mm / 2.0, middle + wall_thickness_mm / 2.0};
  }
  return {*low, *high};
}

}  // namespace

FloorLookup::FloorLookup(const Outlines& of, const ShapeIndex& index)
    : outlines(of), shapes(index), room_mm2(of.rooms.size(), 0.0) {
  for (std::size_t s = 0; s < of.shapes_mm.size(); ++s) {
    room_mm2[static_cast<std::size_t>(of.room_of_shape[s])] += area(of.shapes_mm[s]);
  }
}

Ring door_opening(const Segment2& jambs_mm, const FloorLookup& floors, int first, int second,
                  double wall_thickness_mm) {
  const Point2 along = jambs_mm.b - jambs_mm.a;
  const Point2 unit = along.normalized();
  const Point2 normal(-unit.y(), unit.x());
  const std::vector<NearEdge> near = edges_across(floors, jambs_mm);
  Ends between;
  for (const double fraction : kAcross) {
    add(gap_at_door({floors, near, jambs_mm.a + fraction * along, normal}, first, second), between);
  }
  Ends beside;
  for (const double aside_mm : {kMaxAside_mm / 2.0, kMaxAside_mm}) {
    for (const Point2& base :
         {Point2(jambs_mm.a - aside_mm * unit), Point2(jambs_mm.b + aside_mm * unit)}) {
      const auto gap = gap_at_door({floors, near, base, normal}, first, second);
      const bool is_wall = gap && gap->room_low >= 0 && gap->room_high >= 0 &&
                           gap->room_low != gap->room_high &&
                           gap->high_mm - gap->low_mm <= kMaxBesideDepth_mm;
      if (is_wall) add(gap, beside);
    }
  }
  const Depth depth = depth_of(between, beside, wall_thickness_mm);
  return rounded({jambs_mm.a + depth.low_mm * normal, jambs_mm.b + depth.low_mm * normal,
                  jambs_mm.b + depth.high_mm * normal, jambs_mm.a + depth.high_mm * normal});
}

}  // namespace roomatlas::planar
