// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_pieces.hpp"

#include "roomatlas/draw/assumed_walls.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace roomatlas::drawing {
namespace {

constexpr double kCell_m = 1.0;          // of the grid in which faces are looked up
constexpr double kThinnest_m = 0.01;     // nearer faces are one and the same
constexpr double kParallel_sine = 0.07;  // 4 degrees: faces so near to parallel are one wall's
constexpr double kShortest_m = 0.02;     // shorter stretches are not worth a mark
constexpr double kThickest_m = 0.6;      // of a wall that is looked through for its other face
constexpr double kAssumed_m = 0.15;      // of a wall of which the other face is not found
constexpr double kSample_m = 0.1;        // between places at which a wall's depth is measured
constexpr double kSameDepth_m = 0.02;    // depths that differ by less are one
constexpr double kOnFace_m = 0.05;       // an edge so near to a face tells of it

Point2 left_of(const Point2& direction) { return {-direction.y(), direction.x()}; }

void add_ring(SegmentGrid& faces, Ring ring, bool is_hole) {
  if ((signed_area(ring) > 0.0) == is_hole) std::reverse(ring.begin(), ring.end());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    faces.add({ring[i], ring[(i + 1) % ring.size()]});
  }
}

/// The stretch between a face and another one that looks the other way, if they are near.
std::optional<Ring> between(const Segment2& face, const Segment2& other, double thickest_m) {
  const double length_m = (face.b - face.a).norm();
  const Point2 along = (face.b - face.a) / length_m;
  const Point2 back = (other.b - other.a).normalized();
  if (along.dot(back) > 0.0 || std::abs(cross(along, back)) > kParallel_sine) return std::nullopt;
  const Point2 across = left_of(along);
  const auto place = [&](const Point2& point) {
    return Point2(along.dot(point - face.a), across.dot(point - face.a));
  };
  const Point2 near = place(other.b);  // it runs backwards
  const Point2 far = place(other.a);
  const double begin = std::max(0.0, near.x());
  const double end = std::min(length_m, far.x());
  if (end - begin < kShortest_m) return std::nullopt;
  const auto depth_at = [&](double u) {
    return near.y() + (far.y() - near.y()) * (u - near.x()) / (far.x() - near.x());
  };
  const double least = std::min(depth_at(begin), depth_at(end));
  const double most = std::max(depth_at(begin), depth_at(end));
  if (least < kThinnest_m || most > thickest_m) return std::nullopt;
  const auto at = [&](double u, double v) { return Point2(face.a + u * along + v * across); };
  return Ring{at(begin, 0.0), at(end, 0.0), at(end, depth_at(end)), at(begin, depth_at(begin))};
}

/// How far from `from` the first face stands in that direction; nothing within `reach_m`.
std::optional<double> reach(const SegmentGrid& faces, const Point2& from, const Point2& towards,
                            double reach_m) {
  const Segment2 ray{from, from + reach_m * towards};
  std::optional<double> nearest;
  for (const std::size_t i : faces.near(box_around(ray, 0.01))) {
    const auto share = crossing_fraction(ray, faces.segments()[i]);
    if (share && (!nearest || *share * reach_m < *nearest)) nearest = *share * reach_m;
  }
  return nearest;
}

/// What lies beyond the end of a thin stretch up to the next face, or to the next thin stretch.
std::optional<Ring> junction(const SegmentGrid& faces, const std::vector<Ring>& strips,
                             const Ring& strip, bool at_end, double thickest_m) {
  const Point2 low = at_end ? strip[1] : strip[0];
  const Point2 high = at_end ? strip[2] : strip[3];
  const Point2 towards = (at_end ? 1.0 : -1.0) * (strip[1] - strip[0]).normalized();
  const Point2 middle = (low + high) / 2.0;
  constexpr double kSlack = 1.1;  // of a thickness, since walls may meet askew
  std::optional<double> depth =
      reach(faces, middle + 0.001 * towards, towards, kSlack * thickest_m);
  for (const Ring& other : strips) {
    for (const Point2& end :
         {Point2((other[0] + other[3]) / 2.0), Point2((other[1] + other[2]) / 2.0)}) {
      const Point2 way = end - middle;
      const double run = way.dot(towards);
      const bool is_ahead = run > kThinnest_m && run < kSlack * thickest_m &&
                            std::abs(cross(towards, way)) < 0.3 * thickest_m;
      if (is_ahead && (!depth || run < *depth)) depth = run;
    }
  }
  if (!depth) return std::nullopt;
  return Ring{low, low + *depth * towards, high + *depth * towards, high};
}

}  // namespace

SegmentGrid wall_faces(const std::vector<Polygon>& walls) {
  SegmentGrid faces(kCell_m);
  for (const Polygon& wall : walls) {
    add_ring(faces, wall.outer, false);
    for (const Ring& hole : wall.holes) add_ring(faces, hole, true);
  }
  return faces;
}

std::vector<Ring> thin_walls(const SegmentGrid& faces, double thickest_m) {
  std::vector<Ring> strips;
  const std::vector<Segment2>& all = faces.segments();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if ((all[i].b - all[i].a).norm() < kShortest_m) continue;
    for (const std::size_t k : faces.near(box_around(all[i], thickest_m))) {
      if (k <= i || (all[k].b - all[k].a).norm() < kShortest_m) continue;
      if (auto strip = between(all[i], all[k], thickest_m)) strips.push_back(*std::move(strip));
    }
  }
  std::vector<Ring> joined = strips;
  SegmentGrid middles(kCell_m);
  for (const Ring& strip : strips) {
    middles.add({(strip[0] + strip[3]) / 2.0, (strip[1] + strip[2]) / 2.0});
  }
  for (const Ring& strip : strips) {
    for (const bool at_end : {false, true}) {
      const Point2 end = at_end ? strip[1] : strip[0];
      std::vector<Ring> near;
      for (const std::size_t k : middles.near(box_around({end, end}, 2.0 * thickest_m))) {
        near.push_back(strips[k]);
      }
      if (auto ring = junction(faces, near, strip, at_end, thickest_m)) {
        joined.push_back(*std::move(ring));
      }
    }
  }
  return joined;
}

Point2 AssumedWall::back() const {
  const Point2 along = (edge.b - edge.a).normalized();
  return {depth_m * along.y(), -depth_m * along.x()};
}

Segment2 AssumedWall::face() const { return {edge.a + back(), edge.b + back()}; }

namespace {

/// Whether a measured edge of another room runs along the place.
bool is_measured(const SegmentGrid& measured, const Point2& at, const Point2& along) {
  for (const std::size_t i : measured.near(box_around({at, at}, kOnFace_m))) {
    const Segment2& edge = measured.segments()[i];
    const bool is_parallel =
        std::abs(cross(along, (edge.b - edge.a).normalized())) <= 2.0 * kParallel_sine;
    if (is_parallel && distance(edge, at) <= kOnFace_m) return true;
  }
  return false;
}

/// The wall behind one place of an edge.
AssumedWall behind(const Segment2& piece, WallEvidence evidence, const SegmentGrid& faces,
                   const SegmentGrid& measured) {
  AssumedWall wall{piece, evidence};
  const Point2 along = (piece.b - piece.a).normalized();
  const Point2 outwards = -left_of(along);
  const Point2 middle = (piece.a + piece.b) / 2.0;
  constexpr double kStart_m = 0.015;  // beyond the face that the edge itself is
  const auto depth = reach(faces, middle + kStart_m * outwards, outwards, kThickest_m);
  wall.depth_m = depth ? *depth + kStart_m : kAssumed_m;
  wall.is_half = depth && is_measured(measured, middle + wall.depth_m * outwards, along);
  if (wall.is_half) wall.depth_m /= 2.0;
  return wall;
}

}  // namespace

std::vector<AssumedWall> assumed_pieces(const FloorPlan& plan, const SegmentGrid& faces) {
  SegmentGrid measured(kCell_m);
  for (const PlanEdge& edge : plan.edges) {
    if (edge.evidence == WallEvidence::measured) measured.add(edge.line);
  }
  std::vector<AssumedWall> walls;
  for (const PlanEdge& edge : plan.edges) {
    const Point2 run = edge.line.b - edge.line.a;
    const bool is_assumed = edge.evidence != WallEvidence::measured;
    if (!is_assumed || !run.allFinite() || run.norm() == 0.0) continue;
    const int steps = std::max(1, static_cast<int>(std::lround(run.norm() / kSample_m)));
    const auto at = [&](int k) { return Point2(edge.line.a + run * (double(k) / steps)); };
    const std::size_t first = walls.size();
    for (int k = 0; k < steps; ++k) {
      const AssumedWall piece = behind({at(k), at(k + 1)}, edge.evidence, faces, measured);
      const bool goes_on = walls.size() > first && piece.is_half == walls.back().is_half &&
                           std::abs(piece.depth_m - walls.back().depth_m) < kSameDepth_m;
      if (goes_on) {
        walls.back().edge.b = piece.edge.b;
      } else {
        walls.push_back(piece);
      }
    }
  }
  return walls;
}

std::vector<Ring> bodies_of(const std::vector<AssumedWall>& walls) {
  const auto key = [](const Point2& point) {
    return std::pair(std::llround(1000.0 * point.x()), std::llround(1000.0 * point.y()));
  };
  std::multimap<std::pair<long long, long long>, const AssumedWall*> begins;
  std::vector<Ring> bodies;
  for (const AssumedWall& wall : walls) {
    begins.emplace(key(wall.edge.a), &wall);
    bodies.push_back({wall.edge.a, wall.face().a, wall.face().b, wall.edge.b});
  }
  for (const AssumedWall& wall : walls) {
    const Point2 corner = wall.edge.b;
    const auto [first, last] = begins.equal_range(key(corner));
    for (auto next = first; next != last; ++next) {
      const AssumedWall& other = *next->second;
      const bool is_convex = cross(wall.edge.b - wall.edge.a, other.edge.b - other.edge.a) > 0.0;
      if (!is_convex) continue;
      bodies.push_back({corner, corner + wall.back(), corner + wall.back() + other.back(),
                        corner + other.back()});
    }
  }
  return bodies;
}

}  // namespace roomatlas::drawing

namespace roomatlas {

std::vector<Ring> assumed_walls(const FloorPlan& plan) {
  return drawing::bodies_of(drawing::assumed_pieces(plan, drawing::wall_faces(plan.walls)));
}

}  // namespace roomatlas
