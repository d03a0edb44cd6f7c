// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/planar/edges.hpp"

#include <span>
#include <vector>

namespace roomatlas::planar {

/// How often a ring runs along an edge from its lower to its higher point; negative: the other way.
struct RingUse {
  int ring = 0;
  int turns = 0;
};

/// Edges that meet in end points only, each as two half-edges with a face on the left of each.
/// Half-edge 2e runs from the lower to the higher point number of edge e, 2e + 1 back.
class PlaneGraph {
 public:
  static constexpr int kOutside = 0;  ///< the unbounded face

  /// @param cut as `cut_where_they_meet` gives it.
  explicit PlaneGraph(EdgeSet cut);

  [[nodiscard]] int half_edge_count() const { return static_cast<int>(origin_.size()); }
  [[nodiscard]] int face_count() const { return face_count_; }
  [[nodiscard]] int point_count() const { return static_cast<int>(points_mm_.size()); }
  [[nodiscard]] static int twin(int half_edge) { return half_edge ^ 1; }
  [[nodiscard]] int origin(int half_edge) const { return at(origin_, half_edge); }
  [[nodiscard]] const Point2& point(int index) const {
    return points_mm_[static_cast<std::size_t>(index)];
  }
  /// The half-edge that follows along the same face.
  [[nodiscard]] int next(int half_edge) const { return at(next_, half_edge); }
  /// The face on the left; 0 is the unbounded one.
  [[nodiscard]] int face(int half_edge) const { return at(face_of_loop_, at(loop_, half_edge)); }
  [[nodiscard]] double area_mm2(int face) const {
    return area_mm2_[static_cast<std::size_t>(face)];
  }
  [[nodiscard]] double length_mm(int half_edge) const {
    return (point(origin(half_edge)) - point(origin(twin(half_edge)))).norm();
  }
  /// The rings along an edge, by ring.
  [[nodiscard]] std::span<const RingUse> uses(int edge) const {
    const auto begin = static_cast<std::size_t>(at(first_use_, edge));
    return {uses_.data() + begin, static_cast<std::size_t>(at(first_use_, edge + 1)) - begin};
  }
  /// One half-edge of each loop along the face's border: its outside, and one a hole.
  [[nodiscard]] std::span<const int> loops_of(int face) const {
    const auto begin = static_cast<std::size_t>(at(first_loop_, face));
    return {loop_starts_.data() + begin,
            static_cast<std::size_t>(at(first_loop_, face + 1)) - begin};
  }

 private:
  [[nodiscard]] static int at(const std::vector<int>& values, int index) {
    return values[static_cast<std::size_t>(index)];
  }
  void join_equal_edges(const std::vector<RingEdge>& edges);
  void link_half_edges();
  void sort_by_angle(std::span<int> outgoing) const;
  void find_loops();
  void find_faces();
  [[nodiscard]] std::vector<int> outer_loops() const;
  void measure_faces();

  std::vector<Point2> points_mm_;
  std::vector<int> origin_;
  std::vector<int> next_;
  std::vector<int> first_use_;
  std::vector<RingUse> uses_;
  std::vector<int> loop_;   ///< of each half-edge
  std::vector<int> start_;  ///< a half-edge of each loop
  std::vector<int> face_of_loop_;
  std::vector<int> first_loop_;  ///< of each face in `loop_starts_`, and one more
  std::vector<int> loop_starts_;
  std::vector<double> area_mm2_;
  int face_count_ = 1;  ///< the unbounded one is always there
};

}  // namespace roomatlas::planar
