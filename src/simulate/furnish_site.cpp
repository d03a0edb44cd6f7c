// SPDX-License-Identifier: GPL-3.0-or-later
#include "furnish_site.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "roomatlas/simulate/world.hpp"

namespace roomatlas {
namespace {

constexpr double kTouchM = 0.001;  // pieces that touch a wall do not overlap it
constexpr double kBetweenPiecesM =
    0.02;                             // two pieces are two: less, and a plan's rounding joins them
constexpr double kFaceSearchM = 0.3;  // from a room's edge to the face of its wall, either way
constexpr double kBehindM = 0.12;     // a wall so near to a piece's back is behind it
constexpr double kLeastBackedShare = 0.8;  // of a back with wall behind; less stands in openings
constexpr double kBackStepM = 0.1;         // between the points of a back that are looked at

Point2 middle_of(const Ring& ring) {
  Point2 sum = Point2::Zero();
  for (const Point2& corner : ring) sum += corner;
  return sum / static_cast<double>(ring.size());
}

/// A little smaller, so that touching is not meeting.
Ring shrunk(Ring ring) {
  const Point2 middle = middle_of(ring);
  for (Point2& corner : ring) {
    const Point2 in = middle - corner;
    corner += std::min(1.0, 2.0 * kTouchM / in.norm()) * in;
  }
  return ring;
}

template <typename Visit>
void for_each_edge(const Ring& ring, Visit visit) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    visit(Segment2{ring[i], ring[(i + 1) % ring.size()]});
  }
}

/// 0 where the segment enters the ring.
double distance_to(const Ring& ring, const Segment2& segment) {
  if (contains(ring, segment.a)) return 0.0;
  double least_m = std::numeric_limits<double>::infinity();
  for_each_edge(
      ring, [&](const Segment2& edge) { least_m = std::min(least_m, distance(edge, segment)); });
  return least_m;
}

/// 0 where they overlap.
double distance_to(const Ring& first, const Ring& second) {
  if (contains(second, first.front())) return 0.0;
  double least_m = std::numeric_limits<double>::infinity();
  for_each_edge(
      second, [&](const Segment2& edge) { least_m = std::min(least_m, distance_to(first, edge)); });
  return least_m;
}

bool are_apart(const Box2& a, const Box2& b, double by_m) {
  return (a.min.array() >= b.max.array() + by_m).any() ||
         (b.min.array() >= a.max.array() + by_m).any();
}

FloorPlan only_walls(const FloorPlan& world) {
  FloorPlan walls;
  walls.walls = world.walls;
  return walls;
}

/// The part of a segment between x = 0 and `length_m`, where there is one.
std::optional<Segment2> clipped(Segment2 segment, double length_m) {
  if (segment.a.x() > segment.b.x()) std::swap(segment.a, segment.b);
  if (segment.b.x() <= 0.0 || segment.a.x() >= length_m) return std::nullopt;
  const Point2 along = segment.b - segment.a;
  const auto at = [&](double x) {
    if (!(along.x() > 0.0)) return segment.a;
    return Point2(segment.a + (x - segment.a.x()) / along.x() * along);
  };
  return Segment2{segment.a.x() < 0.0 ? at(0.0) : segment.a,
                  segment.b.x() > length_m ? at(length_m) : segment.b};
}

}  // namespace

Ring rectangle_in(const Pose2& world_from_frame, const Point2& min, const Point2& max) {
  return transformed(world_from_frame, Ring{min, {max.x(), min.y()}, max, {min.x(), max.y()}});
}

FurnishSite::FurnishSite(const FloorPlan& world, const FurnishOptions& options)
    : door_clearance_m_(options.door_clearance_m),
      route_clearance_m_(options.route_clearance_m),
      walls_(world.walls),
      wall_index_(only_walls(world)) {
  for (const Polygon& wall : walls_) wall_boxes_.push_back(bounds(wall.outer));
  for (const PlanFurniture& piece : world.furniture) add(piece.outline.outer);
  for (const Polygon& leaf : open_leaves(world)) add(leaf.outer);
  for (const PlanDoor& door : world.doors) {
    if (door.kind == DoorKind::window) continue;
    doors_.push_back(door.jambs);
    for_each_edge(door.opening, [&](const Segment2& edge) { doors_.push_back(edge); });
  }
  for (std::size_t i = 0; i < options.route.size(); ++i) {
    route_.push_back({options.route[i == 0 ? 0 : i - 1], options.route[i]});
  }
}

void FurnishSite::add(const Ring& outline) {
  if (outline.empty()) return;
  pieces_.push_back(outline);
  piece_boxes_.push_back(bounds(outline));
}

bool FurnishSite::meets_wall(const Ring& outline) const {
  const Ring inner = shrunk(outline);
  const Box2 box = bounds(inner);
  const Obstacles near = wall_index_.within((box.min + box.max) / 2.0, box.size().norm() / 2.0);
  if (std::any_of(near.edges.begin(), near.edges.end(),
                  [&](const Segment2& edge) { return distance_to(inner, edge) == 0.0; })) {
    return true;
  }
  for (std::size_t i = 0; i < walls_.size(); ++i) {
    if (!are_apart(box, wall_boxes_[i], 0.0) && contains(walls_[i], inner.front())) return true;
  }
  return false;
}

bool FurnishSite::meets_piece(const Ring& outline) const {
  const Box2 box = bounds(outline);
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (are_apart(box, piece_boxes_[i], kBetweenPiecesM)) continue;
    if (distance_to(pieces_[i], outline) < kBetweenPiecesM) return true;
  }
  return false;
}

bool FurnishSite::is_on_route(const Ring& outline) const {
  return std::any_of(route_.begin(), route_.end(), [&](const Segment2& leg) {
    return distance_to(outline, leg) < route_clearance_m_;
  });
}

bool FurnishSite::is_at_door(const Ring& outline) const {
  return std::any_of(doors_.begin(), doors_.end(), [&](const Segment2& door) {
    return distance_to(outline, door) < door_clearance_m_;
  });
}

bool FurnishSite::has_place_for(const Ring& outline) const {
  return !is_at_door(outline) && has_place_for_leaf(outline);
}

bool FurnishSite::has_place_for_leaf(const Ring& outline) const {
  return !meets_piece(outline) && !is_on_route(outline) && !meets_wall(outline);
}

std::optional<double> FurnishSite::wall_face_m(const Pose2& world_from_line,
                                               double length_m) const {
  const Pose2 line_from_world = inverse(world_from_line);
  const Obstacles near = wall_index_.within(world_from_line * Point2(length_m / 2.0, 0.0),
                                            length_m / 2.0 + kFaceSearchM);
  std::vector<Segment2> faces;
  double face_m = -kFaceSearchM;
  for (const Segment2& edge : near.edges) {
    const auto part = clipped(transformed(line_from_world, edge), length_m);
    if (!part) continue;
    const double ahead_m = std::max(part->a.y(), part->b.y());
    if (ahead_m > kFaceSearchM) continue;  // something in the room, not the wall along the line
    face_m = std::max(face_m, ahead_m);
    faces.push_back(*part);
  }
  int backed = 0;
  int looked_at = 0;
  for (double x = kBackStepM / 2.0; x < length_m; x += kBackStepM) {
    ++looked_at;
    const bool has_wall = std::any_of(faces.begin(), faces.end(), [&](const Segment2& face) {
      return distance(face, Point2(x, face_m)) <= kBehindM;
    });
    if (has_wall) ++backed;
  }
  if (looked_at == 0 || backed < kLeastBackedShare * looked_at) return std::nullopt;
  return face_m;
}

}  // namespace roomatlas
