// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar_map.hpp"

#include "shape_index.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace roomatlas::planar {
namespace {

bool is_before(const Point2& a, const Point2& b) {
  return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
}

/// The distinct vertices and edges of all rings.
struct Edges {
  std::vector<Point2> points;
  std::vector<std::pair<int, int>> pairs;
};

template <typename Visit>
void for_each_ring(const std::vector<Polygon>& shapes, Visit visit) {
  for (const Polygon& shape : shapes) {
    if (shape.outer.size() >= 3) visit(shape.outer);
    for (const Ring& hole : shape.holes) {
      if (hole.size() >= 3) visit(hole);
    }
  }
}

Edges edges_of(const std::vector<Polygon>& shapes) {
  Edges edges;
  for_each_ring(shapes, [&](const Ring& ring) {
    edges.points.insert(edges.points.end(), ring.begin(), ring.end());
  });
  std::sort(edges.points.begin(), edges.points.end(), is_before);
  edges.points.erase(std::unique(edges.points.begin(), edges.points.end()), edges.points.end());
  const auto id = [&](const Point2& point) {
    return static_cast<int>(
        std::lower_bound(edges.points.begin(), edges.points.end(), point, is_before) -
        edges.points.begin());
  };
  for_each_ring(shapes, [&](const Ring& ring) {
    int previous = id(ring.back());
    for (const Point2& point : ring) {
      const int current = id(point);
      if (current != previous) edges.pairs.push_back(std::minmax(previous, current));
      previous = current;
    }
  });
  std::sort(edges.pairs.begin(), edges.pairs.end());
  edges.pairs.erase(std::unique(edges.pairs.begin(), edges.pairs.end()), edges.pairs.end());
  return edges;
}

/// Three corners, their area and how far the triangle is from being flat.
struct Measured {
  double area_mm2 = 0.0;
  double height_mm = 0.0;
  Point2 centroid = Point2::Zero();
};

Measured measured(const TriangleMesh& mesh, const Triangle& triangle) {
  std::array<Point2, 3> p;
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = mesh.points_mm[static_cast<std::size_t>(triangle.corner[i])];
  }
  const double doubled = cross(p[1] - p[0], p[2] - p[0]);
  const double longest =
      std::max({(p[1] - p[0]).norm(), (p[2] - p[1]).norm(), (p[0] - p[2]).norm()});
  return {doubled / 2.0, doubled / longest, (p[0] + p[1] + p[2]) / 3.0};
}

}  // namespace

PlanarMap::PlanarMap(const std::vector<Polygon>& shapes_mm) {
  const Edges edges = edges_of(shapes_mm);
  mesh_ = triangulate(edges.points, edges.pairs);
  flood();
  measure(shapes_mm);
  find_borders();
}

void PlanarMap::flood() {
  region_of_triangle_.assign(mesh_.triangles.size(), -1);
  std::vector<std::size_t> open;
  const auto spread = [&](std::size_t seed, int region) {
    region_of_triangle_[seed] = region;
    open.push_back(seed);
    while (!open.empty()) {
      const Triangle triangle = mesh_.triangles[open.back()];
      open.pop_back();
      for (std::size_t i = 0; i < 3; ++i) {
        if (triangle.is_constrained[i] || triangle.neighbor[i] < 0) continue;
        const auto next = static_cast<std::size_t>(triangle.neighbor[i]);
        if (region_of_triangle_[next] >= 0) continue;
        region_of_triangle_[next] = region;
        open.push_back(next);
      }
    }
  };
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    const Triangle& triangle = mesh_.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const bool leads_outside = triangle.neighbor[i] < 0 && !triangle.is_constrained[i];
      if (leads_outside && region_of_triangle_[t] < 0) spread(t, kOutside);
    }
  }
  int region = kOutside;
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    if (region_of_triangle_[t] < 0) spread(t, ++region);
  }
  regions_.resize(static_cast<std::size_t>(region) + 1);
}

void PlanarMap::measure(const std::vector<Polygon>& shapes_mm) {
  std::vector<Measured> fattest(regions_.size());
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    const auto region = static_cast<std::size_t>(region_of_triangle_[t]);
    const Measured triangle = measured(mesh_, mesh_.triangles[t]);
    regions_[region].area_mm2 += triangle.area_mm2;
    if (triangle.height_mm > fattest[region].height_mm) fattest[region] = triangle;
  }
  regions_[kOutside].area_mm2 = 0.0;
  const ShapeIndex index(shapes_mm);
  for (std::size_t r = 1; r < regions_.size(); ++r) {
    regions_[r].covering = index.covering(fattest[r].centroid);
  }
}

void PlanarMap::find_borders() {
  std::vector<std::tuple<int, int, double>> stretches;
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    const Triangle& triangle = mesh_.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const int beyond = triangle.neighbor[i];
      const int from = region_of_triangle_[t];
      const int to = beyond < 0 ? kOutside : region_of_triangle_[static_cast<std::size_t>(beyond)];
      if (from == to) continue;
      const Point2& a = mesh_.points_mm[static_cast<std::size_t>(triangle.corner[(i + 1) % 3])];
      const Point2& b = mesh_.points_mm[static_cast<std::size_t>(triangle.corner[(i + 2) % 3])];
      stretches.emplace_back(from, to, (b - a).norm());
      if (beyond < 0) stretches.emplace_back(to, from, (b - a).norm());
    }
  }
  std::sort(stretches.begin(), stretches.end());
  for (const auto& [from, to, length] : stretches) {
    auto& borders = regions_[static_cast<std::size_t>(from)].borders;
    if (borders.empty() || borders.back().region != to) borders.push_back({to, 0.0});
    borders.back().length_mm += length;
  }
}

std::vector<std::vector<Polygon>> PlanarMap::trace(const std::vector<int>& group_of_region,
                                                   int groups) const {
  std::vector<int> group_of_triangle;
  group_of_triangle.reserve(region_of_triangle_.size());
  for (const int region : region_of_triangle_) {
    group_of_triangle.push_back(
        region == kOutside ? -1 : group_of_region[static_cast<std::size_t>(region)]);
  }
  return trace_boundaries(mesh_, group_of_triangle, groups);
}

}  // namespace roomatlas::planar
