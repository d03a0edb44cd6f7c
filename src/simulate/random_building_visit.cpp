// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_building_visit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace roomatlas::random_building_layout {
namespace {

constexpr double kSightM = 3.5;      // how far along a corridor its walls are seen
constexpr double kShortestM = 0.05;  // a stretch of wall that is left between two doors

/// A side of the seen part, counter-clockwise: the outside is on the right.
struct Side {
  Point2 from;
  Point2 to;
  bool is_wall = false;

  [[nodiscard]] Point2 unit() const { return (to - from).normalized(); }
  [[nodiscard]] Point2 outward() const { return {unit().y(), -unit().x()}; }
};

std::array<Side, 4> sides_of(const Box2& seen, const Box2& whole) {
  const Point2 a = seen.min;
  const Point2 b(seen.max.x(), seen.min.y());
  const Point2 c = seen.max;
  const Point2 d(seen.min.x(), seen.max.y());
  return {Side{a, b, a.y() <= whole.min.y()}, Side{b, c, b.x() >= whole.max.x()},
          Side{c, d, c.y() >= whole.max.y()}, Side{d, a, d.x() <= whole.min.x()}};
}

/// How far along a side an opening is; nothing where it is in another side.
std::optional<double> along(const Side& side, const LaidOpening& opening) {
  if (!side.is_wall || direction(opening.world_from_pivot.theta_rad).dot(side.outward()) < 0.5) {
    return std::nullopt;
  }
  const double at_m = (opening.world_from_pivot.position() - side.from).dot(side.unit());
  const bool is_seen = at_m > 0.0 && at_m < (side.to - side.from).norm();
  return is_seen ? std::optional(at_m) : std::nullopt;
}

/// Stretches of wall along a side, between its doors.
void add_walls(const Side& side, const Space& space, std::vector<Polyline>& walls) {
  std::vector<std::pair<double, double>> gaps;
  for (const LaidOpening& opening : space.openings) {
    const auto at_m = along(side, opening);
    if (at_m) gaps.emplace_back(*at_m - opening.width_m / 2.0, *at_m + opening.width_m / 2.0);
  }
  std::sort(gaps.begin(), gaps.end());
  const double length_m = (side.to - side.from).norm();
  gaps.emplace_back(length_m, length_m);
  double from_m = 0.0;
  for (const auto& [gap_from_m, gap_to_m] : gaps) {
    const double to_m = std::min(gap_from_m, length_m);
    if (to_m - from_m > kShortestM) {
      const Point2 a = side.from + std::max(0.0, from_m) * side.unit();
      const Point2 b = to_m == length_m ? side.to : Point2(side.from + to_m * side.unit());
      const bool goes_on = !walls.empty() && walls.back().back() == a;
      if (goes_on) {
        walls.back().push_back(b);
      } else {
        walls.push_back({a, b});
      }
    }
    from_m = gap_to_m;
  }
}

/// The doorway on the way along a side: right face, right jamb, left jamb, left face.
void add_niche(const Exit& exit, Ring& ring) {
  const Pose2& pivot = exit.frame_from_pivot;
  const Point2 half(0.0, exit.width_m / 2.0);
  const Point2 depth(kWallM / 2.0, 0.0);
  ring.push_back(pivot * Point2(-half - depth));
  ring.push_back(exit.jambs.b);
  ring.push_back(exit.jambs.a);
  ring.push_back(pivot * Point2(half - depth));
}

class Blur {
 public:
  Blur(double deviation_m, RandomStream& noise) : deviation_m_(deviation_m), noise_(noise) {}
  Point2 operator()(const Point2& point) {
    if (deviation_m_ <= 0.0) return point;
    const double x = noise_.normal();
    return point + deviation_m_ * Point2(x, noise_.normal());
  }

 private:
  double deviation_m_;
  RandomStream& noise_;
};

}  // namespace

Box2 seen_part(const Space& space, const Box2& path_box) {
  if (space.kind != RoomKind::corridor) return space.box;
  const Point2 sight = Point2::Constant(kSightM);
  return {space.box.min.cwiseMax(path_box.min - sight),
          space.box.max.cwiseMin(path_box.max + sight)};
}

VisitShape shape_of_visit(const Space& space, const Box2& seen,
                          const std::vector<UsedDoorway>& used, const Pose2& asr_from_world,
                          double vertex_noise_m, RandomStream& noise) {
  Blur blur(vertex_noise_m, noise);
  VisitShape shape;
  std::vector<Polyline> walls;
  for (const Side& side : sides_of(seen, space.box)) {
    if (side.is_wall) add_walls(side, space, walls);
    shape.outline_asr.outer.push_back(blur(asr_from_world * side.from));
    std::vector<std::pair<double, const Exit*>> doorways;
    for (const UsedDoorway& doorway : used) {
      const auto at_m = along(side, *doorway.opening);
      if (at_m) doorways.emplace_back(*at_m, &doorway.exit);
    }
    std::sort(doorways.begin(), doorways.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [at_m, exit] : doorways) add_niche(*exit, shape.outline_asr.outer);
  }
  if (walls.size() > 1 && walls.back().back() == walls.front().front()) {
    walls.back().insert(walls.back().end(), walls.front().begin() + 1, walls.front().end());
    walls.erase(walls.begin());
  }
  for (Polyline& wall : walls) {
    for (Point2& vertex : wall) vertex = blur(asr_from_world * vertex);
    std::vector<bool> is_fitted(wall.size() - 1, true);
    shape.walls_asr.push_back({std::move(wall), std::move(is_fitted)});
  }
  return shape;
}

}  // namespace roomatlas::random_building_layout
