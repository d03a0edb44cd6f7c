// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that includes CGAL: it costs seconds of compile time.
#include "triangulation.hpp"

// A library does not print. CGAL would advise the "plus" class for exact numbers.
#define CGAL_NO_CDT_2_WARNING

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace roomatlas::planar {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Face = CGAL::Triangulation_face_base_with_info_2<int, Kernel, FaceBase>;
using Structure = CGAL::Triangulation_data_structure_2<Vertex, Face>;
using Cdt =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_intersections_tag>;

/// Numbers the vertices and faces and copies them out.
TriangleMesh mesh_of(const Cdt& cdt) {
  TriangleMesh mesh;
  if (cdt.dimension() < 2) return mesh;
  for (const auto vertex : cdt.finite_vertex_handles()) {
    vertex->info() = static_cast<int>(mesh.points_mm.size());
    mesh.points_mm.emplace_back(CGAL::to_double(vertex->point().x()),
                                CGAL::to_double(vertex->point().y()));
  }
  int count = 0;
  for (const auto face : cdt.all_face_handles()) {
    face->info() = cdt.is_infinite(face) ? -1 : count++;
  }
  mesh.triangles.resize(static_cast<std::size_t>(count));
  for (const auto face : cdt.finite_face_handles()) {
    Triangle& triangle = mesh.triangles[static_cast<std::size_t>(face->info())];
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<std::size_t>(i);
      triangle.corner[at] = face->vertex(i)->info();
      triangle.neighbor[at] = face->neighbor(i)->info();
      triangle.is_constrained[at] = face->is_constrained(i);
    }
  }
  return mesh;
}

}  // namespace

TriangleMesh triangulate(const std::vector<Point2>& points_mm,
                         const std::vector<std::pair<int, int>>& edges) {
  std::vector<Kernel::Point_2> points;
  points.reserve(points_mm.size());
  for (const Point2& point : points_mm) points.emplace_back(point.x(), point.y());
  std::vector<std::pair<std::size_t, std::size_t>> indices;
  indices.reserve(edges.size());
  for (const auto& [a, b] : edges) {
    indices.emplace_back(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
  }
  Cdt cdt;
  cdt.insert_constraints(points.begin(), points.end(), indices.begin(), indices.end());
  return mesh_of(cdt);
}

}  // namespace roomatlas::planar
