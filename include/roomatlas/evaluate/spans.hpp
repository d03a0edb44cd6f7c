// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/issue.hpp"
#include "roomatlas/evaluate/evaluate.hpp"
#include "roomatlas/plan/floor_plan.hpp"

#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace roomatlas {

enum class Side { east, north, west, south };

/// One end of a tape measure.
struct DoorEnd {
  std::int64_t door = 0;  ///< its mid-point
};
struct WallEnd {
  RoomId room = 0;
  Side side = Side::east;
};
struct PointEnd {
  Point2 point = Point2::Zero();  ///< building metres
};
using SpanEnd = std::variant<DoorEnd, WallEnd, PointEnd>;

/// A length that somebody measured in the building.
struct Span {
  std::string name;
  SpanEnd from;
  SpanEnd to;
  double true_m = 0.0;
};

struct MeasuredSpan {
  std::string name;
  double true_m = 0.0;
  double plan_m = std::numeric_limits<double>::quiet_NaN();  ///< NaN: an end is not in the plan
};

struct SpanErrors {
  std::vector<MeasuredSpan> spans;
  Statistics error_m;                                       ///< of the spans that could be measured
  double scale = std::numeric_limits<double>::quiet_NaN();  ///< plan over truth, least squares
  Issues issues;  ///< spans whose ends are not in the plan
};

/// Measures spans in a plan. East is the direction of the plan's walls (modulo a right angle) that
/// is nearest to its x axis. A wall end is the wall that one meets from the room's label point in
/// that direction. A span with a wall end is measured across that wall, other spans straight.
/// Two wall ends must face along one axis; other spans are reported and not measured.
[[nodiscard]] SpanErrors span_errors(const FloorPlan& plan, const std::vector<Span>& spans);

}  // namespace roomatlas
