// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_segments.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <unordered_map>

#include "roomatlas/core/place_index.hpp"
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

/// All edges of the bodies, with the wall to their left.
std::vector<Segment2> edges_of(const std::vector<Polygon>& bodies) {
  std::vector<Segment2> edges;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
    }
  };
  for (const Polygon& body : bodies) {
    add(body.outer);
    for (const Ring& hole : body.holes) add(hole);
  }
  return edges;
}

double length_of(const Segment2& segment) { return (segment.b - segment.a).norm(); }

Box2 box_of(const Segment2& segment, double reach_m) {
  Box2 box = box_around(segment.a, reach_m);
  box.extend(segment.b + Point2(reach_m, reach_m));
  box.extend(segment.b - Point2(reach_m, reach_m));
  return box;
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

/// Where there is wall: of the edges at one height, an odd number lies to the right.
class Solid {
 public:
  /// @param edges of disjoint bodies
  explicit Solid(const std::vector<Segment2>& edges) {
    constexpr double kMostRows = 4096.0;  // an edge lies in no more, however high the plan is
    Box2 box;
    for (const Segment2& edge : edges) {
      box.extend(edge.a);
      box.extend(edge.b);
    }
    if (!box.empty()) row_m_ = std::max(row_m_, box.size().y() / kMostRows);
    for (const Segment2& edge : edges) {
      const auto [low, high] = std::minmax({row_of(edge.a), row_of(edge.b)});
      for (std::int64_t row = low; row <= high; ++row) edges_of_row_[row].push_back(edge);
    }
  }

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
  [[nodiscard]] std::int64_t row_of(const Point2& point) const {
    return static_cast<std::int64_t>(std::floor(point.y() / row_m_));
  }
  [[nodiscard]] bool holds(const Point2& point) const {
    const auto row = edges_of_row_.find(row_of(point));
    if (row == edges_of_row_.end()) return false;
    const auto crossed =
        std::count_if(row->second.begin(), row->second.end(),
                      [&](const Segment2& edge) { return is_crossed_by_ray(edge, point); });
    return crossed % 2 == 1;
  }
  double row_m_ = 0.25;
  std::unordered_map<std::int64_t, std::vector<Segment2>> edges_of_row_;
};

std::vector<Strip> strips_of(const std::vector<Segment2>& edges, const Solid& solid) {
  std::vector<Segment2> faces;
  std::copy_if(edges.begin(), edges.end(), std::back_inserter(faces),
               [](const Segment2& edge) { return length_of(edge) >= kShortest_m; });
  PlaceIndex places;
  for (std::size_t i = 0; i < faces.size(); ++i) places.add(i, box_of(faces[i], 0.0));
  std::vector<Strip> strips;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (const std::size_t k : places.near(box_of(faces[i], kThickest_m))) {
      if (k <= i) continue;
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

/// Takes another stretch into the wall, where both are of one wall and what lies between is too.
bool takes_in(Strip& wall, const Strip& other, const Solid& solid) {
  if (std::abs(other.thickness_m - wall.thickness_m) > kOneLine_m) return false;
  const Pose2 wall_from_building = inverse(wall.building_from_wall);
  const Point2 from = wall_from_building * other.at(other.begin_m, 0.0);
  const Point2 to = wall_from_building * other.at(other.end_m, 0.0);
  if (std::abs(from.y()) > kOneLine_m || std::abs(to.y()) > kOneLine_m) return false;
  const auto [low_m, high_m] = std::minmax({from.x(), to.x()});
  const double gap_from_m = std::min(wall.end_m, high_m) + 0.005;
  const double gap_to_m = std::max(wall.begin_m, low_m) - 0.005;
  const bool is_one = gap_to_m <= gap_from_m || (gap_to_m - gap_from_m <= kThickest_m &&
                                                 solid.holds(wall, gap_from_m, gap_to_m));
  if (!is_one) return false;
  wall.begin_m = std::min(wall.begin_m, low_m);
  wall.end_m = std::max(wall.end_m, high_m);
  return true;
}

/// Stretches of one wall as one, where what lies between them is wall too.
std::vector<Strip> joined(std::vector<Strip> strips, const Solid& solid) {
  std::stable_sort(strips.begin(), strips.end(), is_longer);
  PlaceIndex places;
  for (std::size_t i = 0; i < strips.size(); ++i) places.add(i, bounds(strips[i].ring()));
  std::vector<Strip> walls;
  std::vector<bool> is_used(strips.size(), false);
  for (std::size_t i = 0; i < strips.size(); ++i) {
    if (is_used[i]) continue;
    is_used[i] = true;
    Strip wall = strips[i];
    for (bool has_grown = true; has_grown;) {
      has_grown = false;
      for (const std::size_t k : places.near(bounds(wall.ring(2.0 * kThickest_m)))) {
        if (is_used[k] || !takes_in(wall, strips[k], solid)) continue;
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
  const std::vector<Segment2> edges = edges_of(bodies);
  const Solid solid(edges);
  std::vector<Strip> walls = joined(strips_of(edges, solid), solid);
  for (Strip& wall : walls) extend(wall, solid);
  std::stable_sort(walls.begin(), walls.end(), is_longer);
  std::vector<WallSegment> segments;
  std::vector<Polygon> taken;
  PlaceIndex places;
  const auto keep = [&](WallSegment segment) {
    if (area(segment.outline) >= kSmallest_m2) segments.push_back(std::move(segment));
  };
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const Polygon whole{walls[i].ring(), {}};
    const Box2 box = bounds(whole.outer);
    std::vector<Polygon> cutters;
    for (const std::size_t k : places.near(box)) {
      if (meet(bounds(walls[k].ring()), box)) cutters.push_back(cutter(walls[k], walls[i]));
    }
    const std::vector<Polygon> pieces =
        cutters.empty() ? std::vector<Polygon>{whole} : difference_of({whole}, cutters);
    for (const Polygon& piece : pieces) keep(segment_of(walls[i], piece));
    taken.push_back({walls[i].ring(kThrough_m, kThrough_m), {}});
    places.add(i, box);
  }
  for (const Polygon& rest : difference_of(bodies, taken)) {
    if (!is_sliver(rest)) keep({rest, std::nullopt, 0.0, false});
  }
  return segments;
}

}  // namespace roomatlas::io
