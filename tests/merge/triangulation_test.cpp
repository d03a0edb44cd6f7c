// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/merge/triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace roomatlas::planar {
namespace {

double area_mm2(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const Triangle& triangle : mesh.triangles) {
    const auto p = [&](std::size_t i) {
      return mesh.points_mm[static_cast<std::size_t>(triangle.corner[i])];
    };
    sum += cross(p(1) - p(0), p(2) - p(0)) / 2.0;
  }
  return sum;
}

TEST(Triangulation, OfPointsOnALineHasNoTriangles) {
  EXPECT_TRUE(triangulate({}, {}).triangles.empty());
  EXPECT_TRUE(triangulate({{0, 0}, {5, 5}, {9, 9}}, {{0, 2}, {0, 1}}).triangles.empty());
}

TEST(Triangulation, PutsAPointWhereEdgesCross) {
  const TriangleMesh mesh = triangulate({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{0, 2}, {1, 3}});
  EXPECT_EQ(mesh.points_mm.size(), 5U);
  EXPECT_EQ(mesh.triangles.size(), 4U);
  EXPECT_DOUBLE_EQ(area_mm2(mesh), 4.0);
}

/// 24 random points and an edge from each to another.
struct Tangle {
  std::vector<Point2> points;
  std::vector<std::pair<int, int>> edges;
};

Tangle random_tangle(std::mt19937& random, int extent_mm) {
  std::uniform_int_distribution<int> coordinate(0, extent_mm);
  Tangle tangle;
  for (int i = 0; i < 24; ++i) {
    const Point2 point(coordinate(random), coordinate(random));
    const auto& known = tangle.points;
    if (std::find(known.begin(), known.end(), point) == known.end()) {
      tangle.points.push_back(point);
    }
  }
  const int count = static_cast<int>(tangle.points.size());
  for (int i = 0; i < count; ++i) tangle.edges.emplace_back(i, (i * 7 + 5) % count);
  std::erase_if(tangle.edges, [](const auto& edge) { return edge.first == edge.second; });
  return tangle;
}

/// Whether no edge runs through the inside of a triangle.
bool respects_edges(const TriangleMesh& mesh, const Tangle& tangle) {
  for (const Triangle& triangle : mesh.triangles) {
    Point2 centroid = Point2::Zero();
    double reach = 0.0;
    for (const int corner : triangle.corner) {
      centroid += mesh.points_mm[static_cast<std::size_t>(corner)] / 3.0;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const Segment2 side{mesh.points_mm[static_cast<std::size_t>(triangle.corner[i])],
                          mesh.points_mm[static_cast<std::size_t>(triangle.corner[(i + 1) % 3])]};
      const double height = distance(side, centroid);
      reach = i == 0 ? height : std::min(reach, height);
    }
    for (const auto& [a, b] : tangle.edges) {
      const Segment2 edge{tangle.points[static_cast<std::size_t>(a)],
                          tangle.points[static_cast<std::size_t>(b)]};
      if (distance(edge, centroid) < 0.5 * reach) return false;
    }
  }
  return true;
}

TEST(Triangulation, NoTriangleLiesAcrossAnEdge) {
  std::mt19937 random(5);
  for (const int extent_mm : {6, 40, 3000, 100000}) {
    for (int round = 0; round < 60; ++round) {
      const Tangle tangle = random_tangle(random, extent_mm);
      const TriangleMesh mesh = triangulate(tangle.points, tangle.edges);
      EXPECT_TRUE(respects_edges(mesh, tangle)) << extent_mm << " mm, round " << round;
    }
  }
}

}  // namespace
}  // namespace roomatlas::planar
