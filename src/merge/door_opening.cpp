// SPDX-License-Identifier: GPL-3.0-or-later
#include "door_opening.hpp"

#include "grid.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace roomatlas::planar {
namespace {

constexpr double kReach_mm = 600.0;
constexpr double kStep_mm = 20.0;
constexpr double kPrecision_mm = 1.0;
constexpr double kNotch_mm = 150.0;           // one line may reach this much deeper than the middle
constexpr double kMaxBesideDepth_mm = 600.0;  // a wall beside the door is not thicker

/// The stretch without floor across the door line, as offsets along the normal.
struct Gap {
  double low_mm = 0.0;
  double high_mm = 0.0;
  int room_low = -1;  ///< the floor below `low_mm`; -1: none within reach
  int room_high = -1;
};

/// A line across the door.
struct Probe {
  const FloorLookup& floors;
  Point2 base;
  Point2 normal;

  [[nodiscard]] int room_at(double offset_mm) const {
    return floors.room_at(base + offset_mm * normal);
  }
  /// Where floor begins between an offset with floor and one without; on the floor's side.
  [[nodiscard]] double edge(double floor_mm, double none_mm) const {
    while (std::abs(floor_mm - none_mm) > kPrecision_mm) {
      const double middle = (floor_mm + none_mm) / 2.0;
      (room_at(middle) >= 0 ? floor_mm : none_mm) = middle;
    }
    return floor_mm;
  }
};

/// All gaps along the line, and borders where one room's floor touches another's.
std::vector<Gap> gaps_along(const Probe& probe) {
  std::vector<Gap> gaps;
  bool is_open = false;
  Gap gap;
  int previous = -1;
  for (double at = -kReach_mm; at <= kReach_mm; at += kStep_mm) {
    const int room = probe.room_at(at);
    if (room < 0 && !is_open) {
      const bool is_first = at == -kReach_mm;
      gap = {is_first ? at : probe.edge(at - kStep_mm, at), kReach_mm, previous, -1};
      is_open = true;
    } else if (room >= 0 && is_open) {
      gap.high_mm = probe.edge(at, at - kStep_mm);
      gap.room_high = room;
      gaps.push_back(gap);
      is_open = false;
    } else if (room >= 0 && previous >= 0 && room != previous) {
      gaps.push_back({at - kStep_mm / 2.0, at - kStep_mm / 2.0, previous, room});
    }
    previous = room;
  }
  if (is_open) gaps.push_back(gap);
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

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
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

int FloorLookup::room_at(const Point2& point_mm) const {
  const std::vector<int> found = parts.covering(point_mm);
  return found.empty() ? -1 : room_of_part[static_cast<std::size_t>(found.front())];
}

Ring door_opening(const Segment2& jambs_mm, const FloorLookup& floors, int first, int second,
                  double wall_thickness_mm) {
  const Point2 along = jambs_mm.b - jambs_mm.a;
  const Point2 unit = along.normalized();
  const Point2 normal(-unit.y(), unit.x());
  Ends between;
  for (const double fraction : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    add(gap_at_door({floors, jambs_mm.a + fraction * along, normal}, first, second), between);
  }
  Ends beside;
  for (const double aside_mm : {120.0, 240.0}) {
    for (const Point2& base :
         {Point2(jambs_mm.a - aside_mm * unit), Point2(jambs_mm.b + aside_mm * unit)}) {
      const auto gap = gap_at_door({floors, base, normal}, first, second);
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
