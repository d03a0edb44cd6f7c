// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

namespace roomatlas::test {

/// Polygons as damaged sensors and damaged programs make them, every vertex on a whole millimetre:
/// bow-ties, spikes, repeated vertices and polygons, slivers, reversed rings, holes that leave
/// their polygon, edges that nearly coincide; some sets far from the origin, some with one polygon
/// far off.
class DirtyPolygons {
 public:
  explicit DirtyPolygons(std::uint64_t seed) : random_(seed) {}

  [[nodiscard]] std::vector<Polygon> next() {
    offset_m_ = one_in(4) ? Point2(whole(-4'000'000, 4'000'000), whole(-4'000'000, 4'000'000))
                          : Point2(0.0, 0.0);
    lattice_m_ = one_in(2) ? 0.5 : 0.001;
    size_m_ = one_in(5) ? 0.05 : one_in(5) ? 60.0 : 6.0;
    std::vector<Polygon> polygons;
    for (int i = whole(1, 6); i > 0; --i) {
      if (!polygons.empty() && one_in(6)) {
        polygons.push_back(polygons[polygons.size() / 2]);
        if (one_in(2)) std::reverse(polygons.back().outer.begin(), polygons.back().outer.end());
        continue;
      }
      polygons.push_back({ring(), {}});
      while (one_in(3)) polygons.back().holes.push_back(ring());
    }
    if (one_in(10)) {
      for (Point2& point : polygons.back().outer) point += Point2(whole(0, 100'000), 7.0);
    }
    for (Polygon& polygon : polygons) {
      for (Point2& point : polygon.outer) point = on_grid(point + offset_m_);
      for (Ring& hole : polygon.holes) {
        for (Point2& point : hole) point = on_grid(point + offset_m_);
      }
    }
    return polygons;
  }

 private:
  [[nodiscard]] int whole(int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random_);
  }
  [[nodiscard]] bool one_in(int count) { return whole(1, count) == 1; }
  [[nodiscard]] double anywhere() {
    const double value = std::uniform_real_distribution<double>(0.0, size_m_)(random_);
    return std::round(value / lattice_m_) * lattice_m_;
  }
  static Point2 on_grid(const Point2& point) {
    return {std::round(point.x() * 1000.0) / 1000.0, std::round(point.y() * 1000.0) / 1000.0};
  }

  Ring ring() {
    switch (whole(0, 4)) {
      case 0:
        return sliver();
      case 1:
        return star();
      default:
        return tangle();
    }
  }
  /// A few millimetres wide.
  Ring sliver() {
    const Point2 from(anywhere(), anywhere());
    const Point2 to(anywhere(), anywhere());
    const Point2 aside(whole(-3, 3) * 0.001, whole(-3, 3) * 0.001);
    return {from, to, to + aside, from + aside};
  }
  /// Often a bow-tie, with spikes and repetitions.
  Ring tangle() {
    Ring made;
    for (int i = whole(1, 12); i > 0; --i) {
      if (!made.empty() && one_in(6)) {
        made.push_back(made[made.size() / 2]);
      } else if (made.size() > 1 && one_in(6)) {
        made.push_back(made[made.size() - 2]);
      } else {
        made.emplace_back(anywhere(), anywhere());
      }
    }
    return made;
  }
  /// A room with a rough wall, at times clockwise.
  Ring star() {
    const Point2 centre(anywhere(), anywhere());
    Ring made;
    const int count = whole(3, 30);
    for (int i = 0; i < count; ++i) {
      made.push_back(centre + size_m_ * 0.01 * whole(10, 40) * direction(2.0 * kPi * i / count));
    }
    if (one_in(2)) std::reverse(made.begin(), made.end());
    return made;
  }

  std::mt19937_64 random_;
  Point2 offset_m_ = Point2::Zero();
  double lattice_m_ = 0.001;
  double size_m_ = 6.0;
};

/// The area of what the polygons cover, each under the non-zero rule less its holes: vertical
/// strips between all end points and crossings, in extended precision. Shares nothing with the
/// library.
class StripArea {
 public:
  explicit StripArea(const std::vector<Polygon>& polygons) {
    if (polygons.empty() || polygons.front().outer.empty()) return;
    base_ = polygons.front().outer.front();
    for (std::size_t p = 0; p < polygons.size(); ++p) {
      add(polygons[p].outer, static_cast<int>(p), 0);
      for (std::size_t h = 0; h < polygons[p].holes.size(); ++h) {
        add(polygons[p].holes[h], static_cast<int>(p), static_cast<int>(h) + 1);
      }
    }
  }

  [[nodiscard]] double square_metres() const {
    const std::vector<long double> borders = strip_borders();
    long double sum = 0.0;
    for (std::size_t i = 1; i < borders.size(); ++i) sum += strip(borders[i - 1], borders[i]);
    return static_cast<double>(sum / 1e6L);
  }

 private:
  /// From left to right.
  struct Edge {
    long double x0, y0, x1, y1;
    int polygon, ring, turns;

    [[nodiscard]] long double at(long double x) const {
      return y0 + (y1 - y0) * ((x - x0) / (x1 - x0));
    }
  };

  void add(const Ring& ring, int polygon, int ring_of_polygon) {
    if (ring.size() < 3) return;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto mm = [&](const Point2& p, int axis) {
        return static_cast<long double>(std::llround(p[axis] * 1000.0) -
                                        std::llround(base_[axis] * 1000.0));
      };
      const Point2& a = ring[i];
      const Point2& b = ring[(i + 1) % ring.size()];
      Edge edge{mm(a, 0), mm(a, 1), mm(b, 0), mm(b, 1), polygon, ring_of_polygon, 1};
      if (edge.x0 == edge.x1) continue;
      if (edge.x0 > edge.x1) {
        std::swap(edge.x0, edge.x1);
        std::swap(edge.y0, edge.y1);
        edge.turns = -1;
      }
      edges_.push_back(edge);
    }
  }

  [[nodiscard]] std::vector<long double> strip_borders() const {
    std::vector<long double> borders;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const Edge& e = edges_[i];
      borders.push_back(e.x0);
      borders.push_back(e.x1);
      for (std::size_t j = 0; j < i; ++j) {
        const Edge& f = edges_[j];
        const long double slope_e = (e.y1 - e.y0) / (e.x1 - e.x0);
        const long double slope_f = (f.y1 - f.y0) / (f.x1 - f.x0);
        if (slope_e == slope_f) continue;
        const long double low = std::max(e.x0, f.x0);
        const long double high = std::min(e.x1, f.x1);
        const long double x = low + (f.at(low) - e.at(low)) / (slope_e - slope_f);
        if (x > low && x < high) borders.push_back(x);
      }
    }
    std::sort(borders.begin(), borders.end());
    borders.erase(std::unique(borders.begin(), borders.end()), borders.end());
    return borders;
  }

  [[nodiscard]] long double strip(long double x0, long double x1) const {
    const long double middle = (x0 + x1) / 2.0L;
    std::vector<std::pair<long double, const Edge*>> crossed;
    for (const Edge& edge : edges_) {
      if (edge.x0 < middle && middle < edge.x1) crossed.emplace_back(edge.at(middle), &edge);
    }
    std::sort(crossed.begin(), crossed.end());
    std::map<int, std::map<int, int>> windings;  // of each ring of each polygon
    long double height = 0.0;
    for (std::size_t i = 0; i + 1 < crossed.size(); ++i) {
      const Edge& edge = *crossed[i].second;
      windings[edge.polygon][edge.ring] += edge.turns;
      if (is_covered(windings)) height += crossed[i + 1].first - crossed[i].first;
    }
    return height * (x1 - x0);
  }

  static bool is_covered(const std::map<int, std::map<int, int>>& windings) {
    return std::any_of(windings.begin(), windings.end(), [](const auto& polygon) {
      return std::all_of(
                 polygon.second.begin(), polygon.second.end(),
                 [](const auto& ring) { return (ring.second != 0) == (ring.first == 0); }) &&
             polygon.second.count(0) > 0;
    });
  }

  Point2 base_ = Point2::Zero();
  std::vector<Edge> edges_;
};

}  // namespace roomatlas::test
