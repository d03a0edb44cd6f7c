// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape_index.hpp"

#define BOOST_ALLOW_DEPRECATED_HEADERS  // Boost.Geometry 1.74 includes one of its own

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <utility>

namespace roomatlas::planar {
namespace {

namespace index = boost::geometry::index;
using IndexPoint = boost::geometry::model::d2::point_xy<double>;
using IndexBox = boost::geometry::model::box<IndexPoint>;
using Entry = std::pair<IndexBox, int>;

IndexBox index_box(const Box2& box) {
  return {{box.min.x(), box.min.y()}, {box.max.x(), box.max.y()}};
}

}  // namespace

struct ShapeIndex::Tree {
  index::rtree<Entry, index::quadratic<16>> boxes;
};

ShapeIndex::ShapeIndex(const std::vector<Polygon>& shapes) : tree_(std::make_unique<Tree>()) {
  std::vector<Entry> entries;
  entries.reserve(shapes.size());
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Box2 box = bounds(shapes[i].outer);
    if (!box.empty()) entries.emplace_back(index_box(box), static_cast<int>(i));
  }
  tree_->boxes = decltype(tree_->boxes)(entries);
}

ShapeIndex::~ShapeIndex() = default;

std::vector<int> ShapeIndex::near(const Box2& box) const {
  std::vector<int> found;
  const auto query = index::intersects(index_box(box));
  for (auto it = tree_->boxes.qbegin(query); it != tree_->boxes.qend(); ++it) {
    found.push_back(it->second);
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace roomatlas::planar
