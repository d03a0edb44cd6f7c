// SPDX-License-Identifier: GPL-3.0-or-later
#include "segment_index.hpp"

#define BOOST_ALLOW_DEPRECATED_HEADERS  // Boost.Geometry 1.74 includes one of its own

#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace roomatlas {
namespace {

namespace index = boost::geometry::index;
using IndexPoint = boost::geometry::model::d2::point_xy<double>;
using IndexBox = boost::geometry::model::box<IndexPoint>;
using Entry = std::pair<IndexBox, std::size_t>;

IndexBox box_of(const Segment2& edge) {
  const Point2 low = edge.a.cwiseMin(edge.b);
  const Point2 high = edge.a.cwiseMax(edge.b);
  return {{low.x(), low.y()}, {high.x(), high.y()}};
}

double distance_to(const IndexBox& box, const Point2& point) {
  const Point2 low{box.min_corner().x(), box.min_corner().y()};
  const Point2 high{box.max_corner().x(), box.max_corner().y()};
  return (point - point.cwiseMax(low).cwiseMin(high)).norm();
}

}  // namespace

struct SegmentIndex::Tree {
  index::rtree<Entry, index::quadratic<16>> boxes;
};

SegmentIndex::SegmentIndex(const std::vector<Ring>& rings) : tree_(std::make_unique<Tree>()) {
  std::vector<Entry> entries;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      segments_.push_back({ring[i], ring[(i + 1) % ring.size()]});
      entries.emplace_back(box_of(segments_.back()), entries.size());
    }
  }
  tree_->boxes = decltype(tree_->boxes)(entries);
}

SegmentIndex::~SegmentIndex() = default;

double SegmentIndex::distance(const Point2& point) const {
  double nearest_m = std::numeric_limits<double>::infinity();
  if (segments_.empty()) return nearest_m;  // of none the tree cannot be asked
  const IndexPoint at(point.x(), point.y());
  // Boxes from the nearest on; an edge may lie farther off than its box.
  const auto query = index::nearest(at, static_cast<unsigned>(segments_.size()));
  for (auto entry = tree_->boxes.qbegin(query); entry != tree_->boxes.qend(); ++entry) {
    if (distance_to(entry->first, point) >= nearest_m) break;
    nearest_m = std::min(nearest_m, roomatlas::distance(segments_[entry->second], point));
  }
  return nearest_m;
}

}  // namespace roomatlas
