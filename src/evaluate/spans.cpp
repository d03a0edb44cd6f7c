// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/spans.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace roomatlas {
namespace {

constexpr double kFarM = 1e4;  ///< longer than any building

/// The direction of the walls nearest to the x axis, in [-pi/4, pi/4).
double east_of(const FloorPlan& plan) {
  Point2 sum = Point2::Zero();
  for (const PlanRoom& room : plan.rooms) {
    for (const Polygon& part : room.parts) {
      for (std::size_t i = 0; i < part.outer.size(); ++i) {
        const Point2 along = part.outer[(i + 1) % part.outer.size()] - part.outer[i];
        // Squared, so that long walls outweigh the many short edges of ragged ones.
        sum += along.squaredNorm() * direction(4.0 * std::atan2(along.y(), along.x()));
      }
    }
  }
  return sum.norm() > 0.0 ? wrap_angle(std::atan2(sum.y(), sum.x())) / 4.0 : 0.0;
}

double quarter_turns(Side side) { return static_cast<double>(static_cast<int>(side)); }

/// An end in the plan, and across which direction to measure there.
struct PlacedEnd {
  Point2 point = Point2::Zero();
  std::optional<Point2> across;
};

/// The first boundary that a ray from the room's label point meets.
std::optional<PlacedEnd> wall_of(const PlanRoom& room, double angle_rad) {
  const Point2 across = direction(angle_rad);
  const Segment2 ray{room.label_point, room.label_point + kFarM * across};
  double nearest = std::numeric_limits<double>::infinity();
  const auto look = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto at = crossing_fraction(ray, {ring[i], ring[(i + 1) % ring.size()]});
      if (at) nearest = std::min(nearest, *at);
    }
  };
  for (const Polygon& part : room.parts) {
    look(part.outer);
    for (const Ring& hole : part.holes) look(hole);
  }
  if (!std::isfinite(nearest)) return std::nullopt;
  return PlacedEnd{ray.a + nearest * (ray.b - ray.a), across};
}

class Tape {
 public:
  explicit Tape(const FloorPlan& plan) : plan_(plan), east_rad_(east_of(plan)) {}

  /// The length in the plan, or what is missing.
  std::variant<double, std::string> measure(const Span& span) const {
    const auto from = placed(span.from);
    const auto to = placed(span.to);
    if (!from) return missing(span.from);
    if (!to) return missing(span.to);
    const Point2 apart = to->point - from->point;
    if (from->across && to->across && std::abs(from->across->dot(*to->across)) < 0.5) {
      return std::string("its walls stand at right angles: name two that face each other");
    }
    if (from->across) return std::abs(from->across->dot(apart));
    if (to->across) return std::abs(to->across->dot(apart));
    return apart.norm();
  }

 private:
  [[nodiscard]] std::optional<PlacedEnd> placed(const SpanEnd& end) const {
    if (const auto* point = std::get_if<PointEnd>(&end)) return PlacedEnd{point->point, {}};
    if (const auto* named = std::get_if<DoorEnd>(&end)) {
      const auto door = std::find_if(plan_.doors.begin(), plan_.doors.end(),
                                     [&](const PlanDoor& d) { return d.id == named->door; });
      if (door == plan_.doors.end()) return std::nullopt;
      return PlacedEnd{(door->jambs.a + door->jambs.b) / 2.0, {}};
    }
    const auto& wall = std::get<WallEnd>(end);
    const auto room = std::find_if(plan_.rooms.begin(), plan_.rooms.end(),
                                   [&](const PlanRoom& r) { return r.id == wall.room; });
    if (room == plan_.rooms.end()) return std::nullopt;
    return wall_of(*room, east_rad_ + quarter_turns(wall.side) * kPi / 2.0);
  }

  static std::string missing(const SpanEnd& end) {
    if (const auto* door = std::get_if<DoorEnd>(&end)) {
      return "door " + std::to_string(door->door) + " is not in the plan";
    }
    if (const auto* wall = std::get_if<WallEnd>(&end)) {
      return "room " + std::to_string(wall->room) + " is not in the plan";
    }
    return "a point cannot be placed";
  }

  const FloorPlan& plan_;
  double east_rad_ = 0.0;
};

}  // namespace

SpanErrors span_errors(const FloorPlan& plan, const std::vector<Span>& spans) {
  const Tape tape(plan);
  SpanErrors errors;
  std::vector<double> error_m;
  double mixed = 0.0;
  double squares = 0.0;
  for (const Span& span : spans) {
    MeasuredSpan& measured = errors.spans.emplace_back();
    measured.name = span.name;
    measured.true_m = span.true_m;
    const auto result = tape.measure(span);
    if (const auto* what = std::get_if<std::string>(&result)) {
      errors.issues.push_back({Severity::warning, "", 0, "span " + span.name, *what});
      continue;
    }
    measured.plan_m = std::get<double>(result);
    error_m.push_back(measured.plan_m - span.true_m);
    mixed += measured.plan_m * span.true_m;
    squares += span.true_m * span.true_m;
  }
  errors.error_m = statistics(std::move(error_m));
  if (squares > 0.0) errors.scale = mixed / squares;
  return errors;
}

}  // namespace roomatlas
