// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape_index.hpp"

#define BOOST_ALLOW_DEPRECATED_HEADERS  // Boost.Geometry 1.74 includes one of its own

#include <boost/geometry/algorithms/disjoint.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace roomatlas::planar {
namespace {

namespace index = boost::geometry::index;
using IndexPoint = boost::geometry::model::d2::point_xy<double>;
using IndexBox = boost::geometry::model::box<IndexPoint>;
using Entry = std::pair<IndexBox, int>;

IndexPoint index_point(const Point2& point) { return {point.x(), point.y()}; }

}  // namespace

struct ShapeIndex::Tree {
  index::rtree<Entry, index::quadratic<16>> boxes;
};

int winding_number(const Ring& ring, const Point2& point) {
  int turns = 0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Point2& a = ring[j];
    const Point2& b = ring[i];
    const bool starts_below = a.y() <= point.y();
    if (starts_below == (b.y() <= point.y())) continue;
    const double side = cross(b - a, point - a);
    if (starts_below && side > 0.0) ++turns;
    if (!starts_below && side < 0.0) --turns;
  }
  return turns;
}

bool covers(const Polygon& shape, const Point2& point) {
  return winding_number(shape.outer, point) != 0 &&
         std::all_of(shape.holes.begin(), shape.holes.end(),
                     [&](const Ring& hole) { return winding_number(hole, point) == 0; });
}

ShapeIndex::ShapeIndex(const std::vector<Polygon>& shapes) : shapes_(shapes) {
  std::vector<Entry> entries;
  entries.reserve(shapes.size());
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Box2 box = bounds(shapes[i].outer);
    if (box.empty()) continue;
    entries.emplace_back(IndexBox(index_point(box.min), index_point(box.max)), static_cast<int>(i));
  }
  tree_ = std::make_unique<Tree>();
  tree_->boxes = decltype(tree_->boxes)(entries);
}

ShapeIndex::~ShapeIndex() = default;

std::vector<int> ShapeIndex::covering(const Point2& point) const {
  std::vector<int> found;
  const auto is_over = [&](const Entry& entry) {
    return covers(shapes_[static_cast<std::size_t>(entry.second)], point);
  };
  const auto query = index::intersects(index_point(point)) && index::satisfies(is_over);
  for (auto it = tree_->boxes.qbegin(query); it != tree_->boxes.qend(); ++it) {
    found.push_back(it->second);
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace roomatlas::planar
