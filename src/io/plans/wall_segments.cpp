// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_segments.hpp"

#include <algorithm>
#include <cmath>

#include "roomatlas/core/pose2.hpp"
#include "roomatlas/planar/union.hpp"

namespace roomatlas::io {
namespace {

constexpr double kThinnest_m = 0.03;
constexpr double kThickest_m = 0.6;
constexpr double kShortest_m = 0.05;  // stretches of face that two faces must share
constexpr double kParallel = 0.01;    // sine of the angle between faces of one wall
constexpr double kOneLine_m = 0.005;  // faces that differ by less are on one line
constexpr double kSmallest_m2 = 1e-3;

/// A rectangle in a frame of its own: x along the wall, y across it.
struct Strip {
  Pose2 building_from_wall;  ///< origin on the middle line
  double begin_m = 0.0;
  double end_m = 0.0;
  double thickness_m = 0.0;

  [[nodiscard]] double length_m() const { return end_m - begin_m; }
  [[nodiscard]] Point2 at(double along_m, double across_m) const {
    return building_from_wall * Point2(along_m, across_m);
  }
  /// @param beyond_m that it reaches further at both ends
  /// @param wider_m the same of both sides
  [[nodiscard]] Ring ring(double beyond_m = 0.0, double wider_m = 0.0) const {
    const double half_m = thickness_m / 2.0 + wider_m;
    const double from_m = begin_m - beyond_m;
    const double to_m = end_m + beyond_m;
    return {at(from_m, -half_m), at(to_m, -half_m), at(to_m, half_m), at(from_m, half_m)};
  }
};

/// Faces with the wall to their left.
std::vector<Segment2> faces_of(const std::vector<Polygon>& bodies) {
  std::vector<Segment2> faces;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Segment2 face{ring[i], ring[(i + 1) % ring.size()]};
      if ((face.b - face.a).norm() >= kShortest_m) faces.push_back(face);
    }
  };
  for (const Polygon& body : bodies) {
    add(body.outer);
    for (const Ring& hole : body.holes) add(hole);
  }
  return faces;
}

/// The wall between two faces that look away from each other.
std::optional<Strip> between(const Segment2& face, const Segment2& other) {
  const Point2 along = (face.b - face.a).normalized();
  const Point2 back = (other.b - other.a).normalized();
  if (along.dot(back) > 0.0 || std::abs(cross(along, back)) > kParallel) return std::nullopt;
  const auto place = [&](const Point2& point) {
    return Point2(along.dot(point - face.a), cross(along, point - face.a));
  };
  const Point2 near = place(other.b);  // it runs backwards
  const Point2 far = place(other.a);
  const double begin = std::max(0.0, near.x());
  const double end = std::min((face.b - face.a).norm(), far.x());
  const double depth = (near.y() + far.y()) / 2.0;
  const bool is_wall = end - begin >= kShortest_m && depth >= kThinnest_m && depth <= kThickest_m;
  if (!is_wall || std::abs(near.y() - far.y()) > kOneLine_m) return std::nullopt;
  const Point2 origin = face.a + depth / 2.0 * Point2(-along.y(), along.x());
  // One direction for both ways along a wall.
  const bool is_backwards = along.x() < -kParallel || (along.x() < kParallel && along.y() < 0.0);
  const double heading_rad = std::atan2(along.y(), along.x());
  if (!is_backwards) return Strip{{origin.x(), origin.y(), heading_rad}, begin, end, depth};
  return Strip{{origin.x(), origin.y(), wrap_angle(heading_rad + kPi)}, -end, -begin, depth};
}

/// Where there is wall.
class Solid {
 public:
  explicit Solid(const std::vector<Polygon>& bodies) : bodies_(bodies) {}

  /// Whether wall is all along there, at a few places across.
  [[nodiscard]] bool holds(const Strip& strip, double from_m, double to_m) const {
    const int steps = std::max(2, static_cast<int>(std::ceil((to_m - from_m) / 0.1)));
    for (int i = 0; i <= steps; ++i) {
      if (!holds(strip, from_m + (to_m - from_m) * i / steps)) return false;
    }
    return true;
  }
  [[nodiscard]] bool holds(const Strip& strip, double along_m) const {
    for (const double share : {-0.45, 0.0, 0.45}) {
      if (!holds(strip.at(along_m, share * strip.thickness_m))) return false;
    }
    return true;
  }

 private:
  [[nodiscard]] bool holds(const Point2& point) const {
    return std::any_of(bodies_.begin(), bodies_.end(),
                       [&](const Polygon& body) { return contains(body, point); });
  }
  const std::vector<Polygon>& bodies_;
};

std::vector<Strip> strips_of(const std::vector<Segment2>& all, const Solid& solid) {
  std::vector<Segment2> faces = all;
  const auto low_x = [](const Segment2& face) { return std::min(face.a.x(), face.b.x()); };
  const auto high_x = [](const Segment2& face) { return std::max(face.a.x(), face.b.x()); };
  std::stable_sort(faces.begin(), faces.end(),
                   [&](const Segment2& p, const Segment2& q) { return low_x(p) < low_x(q); });
  std::vector<Strip> strips;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const double reach_m = high_x(faces[i]) + kThickest_m;
    for (std::size_t k = i + 1; k < faces.size() && low_x(faces[k]) <= reach_m; ++k) {
      const auto strip = between(faces[i], faces[k]);
      constexpr double kInside_m = 0.005;  // from ends, where other faces begin
      if (strip && solid.holds(*strip, strip->begin_m + kInside_m, strip->end_m - kInside_m)) {
        strips.push_back(*strip);
      }
    }
  }
  return strips;
}

bool is_longer(const Strip& p, const Strip& q) { return p.length_m() > q.length_m(); }

/// Stretches of one wall as one, where what lies between them is wall too.
std::vector<Strip> joined(std::vector<Strip> strips, const Solid& solid) {
  std::stable_sort(strips.begin(), strips.end(), is_longer);
  std::vector<Strip> walls;
  std::vector<bool> is_used(strips.size(), false);
  for (std::size_t i = 0; i < strips.size(); ++i) {
    if (is_used[i]) continue;
    Strip wall = strips[i];
    for (bool has_grown = true; has_grown;) {
      has_grown = false;
      for (std::size_t k = i + 1; k < strips.size(); ++k) {
        if (is_used[k] || std::abs(strips[k].thickness_m - wall.thickness_m) > kOneLine_m) continue;
        const Point2 from = inverse(wall.building_from_wall) * strips[k].at(strips[k].begin_m, 0.0);
        const Point2 to = inverse(wall.building_from_wall) * strips[k].at(strips[k].end_m, 0.0);
        if (std::abs(from.y()) > kOneLine_m || std::abs(to.y()) > kOneLine_m) continue;
        const double low_m = std::min(from.x(), to.x());
        const double high_m = std::max(from.x(), to.x());
        const double gap_from_m = std::min(wall.end_m, high_m) + 0.005;
        const double gap_to_m = std::max(wall.begin_m, low_m) - 0.005;
        const bool is_one = gap_to_m <= gap_from_m || (gap_to_m - gap_from_m <= kThickest_m &&
                                                       solid.holds(wall, gap_from_m, gap_to_m));
        if (!is_one) continue;
        wall.begin_m = std::min(wall.begin_m, low_m);
        wall.end_m = std::max(wall.end_m, high_m);
        is_used[k] = has_grown = true;
      }
    }
    walls.push_back(wall);
  }
  return walls;
}

/// On into the corners, as far as there is wall.
void extend(Strip& wall, const Solid& solid) {
  constexpr double kStep_m = 0.02;
  const auto reach = [&](double from_m, double way) {
    const auto is_wall = [&](double far_m) { return solid.holds(wall, from_m + way * far_m); };
    double far_m = 0.0;
    while (far_m < kThickest_m && is_wall(far_m + kStep_m)) far_m += kStep_m;
    for (double half_m = kStep_m / 2.0; half_m > 1e-4; half_m /= 2.0) {
      if (is_wall(far_m + half_m)) far_m += half_m;
    }
    return far_m;
  };
  wall.end_m += reach(wall.end_m, 1.0);
  wall.begin_m -= reach(wall.begin_m, -1.0);
}

bool meet(const Box2& a, const Box2& b) {
  return a.min.x() < b.max.x() && b.min.x() < a.max.x() && a.min.y() < b.max.y() &&
         b.min.y() < a.max.y();
}

/// A piece of the wall, which others may have cut.
WallSegment segment_of(const Strip& wall, const Polygon& piece) {
  WallSegment segment{piece, std::nullopt, wall.thickness_m, false};
  Box2 box;
  for (const Point2& corner : piece.outer) box.extend(inverse(wall.building_from_wall) * corner);
  const Point2 size = box.size();
  segment.axis = Segment2{wall.at(box.min.x(), 0.0), wall.at(box.max.x(), 0.0)};
  segment.is_rectangle = size.x() * size.y() - area(piece) < 0.002 * size.x() &&
                         std::abs(size.y() - wall.thickness_m) < 0.003;
  return segment;
}

/// Who is cut by another is cut through, and has no hairs along it, whatever rounding to
/// millimetres does to both.
constexpr double kThrough_m = 0.002;

Polygon cutter(const Strip& by, const Strip& wall) {
  const double turn_rad = by.building_from_wall.theta_rad - wall.building_from_wall.theta_rad;
  const bool is_beside = std::abs(std::sin(turn_rad)) < 0.1;
  return {by.ring(kThrough_m, is_beside ? kThrough_m : 0.0), {}};
}

/// What rounding to millimetres leaves along a wall.
bool is_sliver(const Polygon& piece) {
  constexpr double kWidth_m = 0.005;
  double around_m = 0.0;
  for (std::size_t i = 0; i < piece.outer.size(); ++i) {
    around_m += (piece.outer[(i + 1) % piece.outer.size()] - piece.outer[i]).norm();
  }
  return 2.0 * area(piece) < kWidth_m * around_m;
}

}  // namespace

std::vector<WallSegment> wall_segments(const FloorPlan& plan) {
  std::vector<Polygon> shapes = plan.walls;
  for (const PlanDoor& door : plan.doors) {
    if (door.opening.size() > 2) shapes.push_back({door.opening, {}});
  }
  const std::vector<Polygon> bodies = union_of(shapes);
  const Solid solid(bodies);
  std::vector<Strip> walls = joined(strips_of(faces_of(bodies), solid), solid);
  for (Strip& wall : walls) extend(wall, solid);
  std::stable_sort(walls.begin(), walls.end(), is_longer);
  std::vector<WallSegment> segments;
  std::vector<Polygon> taken;
  std::vector<Box2> boxes;
  const auto keep = [&](WallSegment segment) {
    if (area(segment.outline) >= kSmallest_m2) segments.push_back(std::move(segment));
  };
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const Polygon whole{walls[i].ring(), {}};
    const Box2 box = bounds(whole.outer);
    std::vector<Polygon> cutters;
    for (std::size_t k = 0; k < i; ++k) {
      if (meet(boxes[k], box)) cutters.push_back(cutter(walls[k], walls[i]));
    }
    const std::vector<Polygon> pieces =
        cutters.empty() ? std::vector<Polygon>{whole} : difference_of({whole}, cutters);
    for (const Polygon& piece : pieces) keep(segment_of(walls[i], piece));
    taken.push_back({walls[i].ring(kThrough_m, kThrough_m), {}});
    boxes.push_back(box);
  }
  for (const Polygon& rest : difference_of(bodies, taken)) {
    if (!is_sliver(rest)) keep({rest, std::nullopt, 0.0, false});
  }
  return segments;
}

}  // namespace roomatlas::io
