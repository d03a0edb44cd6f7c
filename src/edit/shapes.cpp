// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "editable.hpp"
#include "roomatlas/planar/union.hpp"

namespace roomatlas::edit {
namespace {

constexpr double kOnLine_m = 0.02;    // of an edge that was there; merging rounds to less
constexpr double kShortest_m = 0.01;  // of an edge

/// A stretch of a ring's edge with the edge that was there.
struct Stretch {
  double from_m = 0.0;
  double to_m = 0.0;
  const PlanEdge* was = nullptr;
};

std::vector<Stretch> stretches_on(const Segment2& side, const std::vector<PlanEdge>& were) {
  const double length_m = (side.b - side.a).norm();
  const Point2 along = (side.b - side.a) / length_m;
  std::vector<Stretch> stretches;
  for (const PlanEdge& edge : were) {
    const Point2 a = edge.line.a - side.a;
    const Point2 b = edge.line.b - side.a;
    if (std::abs(cross(along, a)) > kOnLine_m || std::abs(cross(along, b)) > kOnLine_m) continue;
    const double from_m = std::max(0.0, along.dot(a));
    const double to_m = std::min(length_m, along.dot(b));
    if (to_m - from_m > kShortest_m) stretches.push_back({from_m, to_m, &edge});
  }
  std::stable_sort(stretches.begin(), stretches.end(),
                   [](const Stretch& a, const Stretch& b) { return a.from_m < b.from_m; });
  return stretches;
}

void add_side(RoomId room, const Segment2& side, const std::vector<PlanEdge>& were,
              std::vector<PlanEdge>& edges) {
  const double length_m = (side.b - side.a).norm();
  if (length_m < kShortest_m) return;
  const Point2 along = (side.b - side.a) / length_m;
  const auto add = [&](double from_m, double to_m, const PlanEdge* was) {
    if (to_m - from_m < kShortest_m) return;
    PlanEdge edge{room,
                  {side.a + from_m * along, side.a + to_m * along},
                  WallEvidence::inferred,
                  std::nullopt};
    if (was != nullptr) {
      edge.evidence = was->evidence;
      edge.deviation_m = was->deviation_m;
    }
    edges.push_back(edge);
  };
  double at_m = 0.0;
  for (const Stretch& stretch : stretches_on(side, were)) {
    add(at_m, stretch.from_m, nullptr);
    add(std::max(at_m, stretch.from_m), stretch.to_m, stretch.was);
    at_m = std::max(at_m, stretch.to_m);
  }
  add(at_m, length_m, nullptr);
}

void add_ring(RoomId room, const Ring& ring, const std::vector<PlanEdge>& were,
              std::vector<PlanEdge>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    add_side(room, {ring[i], ring[(i + 1) % ring.size()]}, were, edges);
  }
}

}  // namespace

Shapes shapes_of(const std::vector<PlacedOutline>& outlines, RoomId room) {
  Shapes shapes;
  for (const PlacedOutline& outline : outlines) {
    if (outline.room == room && outline.outline.outer.size() > 2) shapes.push_back(outline.outline);
  }
  return union_of(shapes);
}

std::vector<PlanEdge> refitted(RoomId room, const Shapes& shapes,
                               const std::vector<PlanEdge>& were) {
  std::vector<PlanEdge> edges;
  for (const Polygon& shape : shapes) {
    add_ring(room, shape.outer, were, edges);
    for (const Ring& hole : shape.holes) add_ring(room, hole, were, edges);
  }
  return edges;
}

void set_shapes(MappedBuilding& building, RoomId room, const Shapes& shapes) {
  std::vector<PlacedOutline>& outlines = building.outlines;
  const auto is_its = [&](const PlacedOutline& outline) { return outline.room == room; };
  const auto first = std::find_if(outlines.begin(), outlines.end(), is_its);
  const AsrId asr = first == outlines.end() ? 0 : first->asr;
  const auto place = first - outlines.begin();
  outlines.erase(std::remove_if(first, outlines.end(), is_its), outlines.end());
  std::vector<PlacedOutline> now;
  for (const Polygon& shape : shapes) now.push_back({asr, room, shape});
  outlines.insert(outlines.begin() + place, now.begin(), now.end());
  if (building.edges.empty()) return;
  std::vector<PlanEdge> edges;
  for (const PlanEdge& edge : building.edges) {
    if (edge.room != room) edges.push_back(edge);
  }
  const std::vector<PlanEdge> own = refitted(room, shapes, building.edges);
  const auto next = std::find_if(edges.begin(), edges.end(),
                                 [&](const PlanEdge& edge) { return edge.room > room; });
  edges.insert(next, own.begin(), own.end());
  building.edges = std::move(edges);
}

double area_of(const Shapes& shapes) {
  double sum = 0.0;
  for (const Polygon& shape : shapes) sum += area(shape);
  return sum;
}

bool covers(const Shapes& shapes, const Point2& point) {
  return std::any_of(shapes.begin(), shapes.end(),
                     [&](const Polygon& shape) { return contains(shape, point); });
}

Point2 left_of(const Segment2& line) {
  const Point2 along = (line.b - line.a).normalized();
  return {-along.y(), along.x()};
}

Polygon band(const Segment2& line, double left_m, double right_m, double beyond_m) {
  const Point2 left = left_of(line);
  const Point2 along(left.y(), -left.x());
  const Point2 a = line.a - beyond_m * along;
  const Point2 b = line.b + beyond_m * along;
  return {{a - right_m * left, b - right_m * left, b + left_m * left, a + left_m * left}, {}};
}

}  // namespace roomatlas::edit
