// SPDX-License-Identifier: GPL-3.0-or-later
#include "predicates.hpp"
#include "roomatlas/planar/edges.hpp"
#include "segment_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace roomatlas::planar {
namespace {

constexpr int kMaxRounds = 40;           // never reached by 10,000 dirty sets of polygons
constexpr double kTilesPerFresh = 4.0;   // at most: memory
constexpr std::size_t kSortedCell = 24;  // edges from which sorting a cell pays

/// An edge has to be cut at a point.
struct Cut {
  int edge = 0;
  int point = 0;
  bool is_exact = true;  ///< the point lies on the edge, so that the cut does not bend it
};

/// Finds where edges meet, and cuts them.
class Cutter {
 public:
  explicit Cutter(EdgeSet& set)
      : set_(set), numbers_(set.points_mm, set.points_mm.size()), is_fresh_(set.edges.size(), 1) {}

  /// @return false when no edge met another: all is done.
  bool cut_once();

 private:
  void find_cuts();
  [[nodiscard]] std::vector<int> near_fresh() const;
  void test_cell(std::vector<int>& cell);
  void test(int first, int second);
  void test_sharing(int first, int second, int shared);
  void test_apart(int first, int second);
  /// Cuts the edge at the point if it lies between the ends; the caller knows that it is on the
  /// line.
  void cut_if_between(int edge, int point);
  [[nodiscard]] Point2 crossing(int first, int second) const;
  void apply_cuts();

  [[nodiscard]] const RingEdge& edge(int index) const {
    return set_.edges[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] bool is_fresh(int index) const {
    return is_fresh_[static_cast<std::size_t>(index)] != 0;
  }

  EdgeSet& set_;
  PointNumbers numbers_;
  std::vector<char> is_fresh_;  ///< of each edge: not yet compared with the others
  std::vector<Box2> boxes_;
  std::vector<Cut> cuts_;
};

bool overlap(const Box2& a, const Box2& b) {
  return a.min.x() <= b.max.x() && b.min.x() <= a.max.x() && a.min.y() <= b.max.y() &&
         b.min.y() <= a.max.y();
}

bool Cutter::cut_once() {
  cuts_.clear();
  find_cuts();
  if (cuts_.empty()) return false;
  apply_cuts();
  return true;
}

/// The edges that may meet a fresh one: those whose boxes share a tile with a fresh edge's box.
std::vector<int> Cutter::near_fresh() const {
  std::vector<int> near;
  Box2 fresh_box;
  double size = 0.0;
  int fresh = 0;
  for (std::size_t e = 0; e < boxes_.size(); ++e) {
    if (is_fresh_[e] == 0) continue;
    fresh_box.extend(boxes_[e].min);
    fresh_box.extend(boxes_[e].max);
    size += boxes_[e].size().sum();
    ++fresh;
  }
  if (fresh == static_cast<int>(boxes_.size())) {  // the first round
    near.resize(boxes_.size());
    std::iota(near.begin(), near.end(), 0);
    return near;
  }
  if (fresh == 0) return near;
  const double tile =
      std::max(size / fresh, fresh_box.size().maxCoeff() / std::sqrt(kTilesPerFresh * fresh)) + 1.0;
  const auto index = [&](double offset, double extent) {
    return static_cast<std::size_t>(std::clamp(offset, 0.0, extent) / tile);
  };
  const Point2 extent = fresh_box.size();
  const std::size_t columns = index(extent.x(), extent.x()) + 1;
  std::vector<char> is_marked(columns * (index(extent.y(), extent.y()) + 1), 0);
  /// Calls `visit` with tiles until it returns true.
  const auto any_tile = [&](const Box2& box, auto visit) {
    const std::size_t last_x = index(box.max.x() - fresh_box.min.x(), extent.x());
    const std::size_t last_y = index(box.max.y() - fresh_box.min.y(), extent.y());
    for (std::size_t y = index(box.min.y() - fresh_box.min.y(), extent.y()); y <= last_y; ++y) {
      for (std::size_t x = index(box.min.x() - fresh_box.min.x(), extent.x()); x <= last_x; ++x) {
        if (visit(is_marked[y * columns + x])) return true;
      }
    }
    return false;
  };
  for (std::size_t e = 0; e < boxes_.size(); ++e) {
    if (is_fresh_[e] == 0) continue;
    (void)any_tile(boxes_[e], [](char& mark) {
      mark = 1;
      return false;
    });
  }
  for (std::size_t e = 0; e < boxes_.size(); ++e) {
    if (!overlap(boxes_[e], fresh_box)) continue;
    if (any_tile(boxes_[e], [](char mark) { return mark != 0; }))
      near.push_back(static_cast<int>(e));
  }
  return near;
}

void Cutter::find_cuts() {
  boxes_.clear();
  boxes_.reserve(set_.edges.size());
  for (const RingEdge& edge : set_.edges) {
    const Point2& a = set_.point(edge.from);
    const Point2& b = set_.point(edge.to);
    boxes_.push_back({a.cwiseMin(b), a.cwiseMax(b)});
  }
  const std::vector<int> near = near_fresh();
  const SegmentGrid grid(set_, near);
  std::vector<int> cell;
  for (int c = 0; c < grid.cell_count(); ++c) {
    if (grid.in_cell(c).size() < 2) continue;
    cell.clear();
    for (const int place : grid.in_cell(c)) cell.push_back(near[static_cast<std::size_t>(place)]);
    test_cell(cell);
  }
}

void Cutter::test_cell(std::vector<int>& cell) {
  const auto box = [&](int e) -> const Box2& { return boxes_[static_cast<std::size_t>(e)]; };
  const bool is_sorted = cell.size() >= kSortedCell;
  if (is_sorted) {
    std::sort(cell.begin(), cell.end(),
              [&](int a, int b) { return box(a).min.x() < box(b).min.x(); });
  }
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const Box2& around = box(cell[i]);
    for (std::size_t j = i + 1; j < cell.size(); ++j) {
      if (is_sorted && box(cell[j]).min.x() > around.max.x()) break;
      if (!overlap(around, box(cell[j]))) continue;
      if (is_fresh(cell[i]) || is_fresh(cell[j])) test(cell[i], cell[j]);
    }
  }
}

void Cutter::test(int first, int second) {
  const RingEdge& a = edge(first);
  const RingEdge& b = edge(second);
  const bool shares_from = a.from == b.from || a.from == b.to;
  const bool shares_to = a.to == b.from || a.to == b.to;
  if (shares_from && shares_to) return;
  if (shares_from) return test_sharing(first, second, a.from);
  if (shares_to) return test_sharing(first, second, a.to);
  test_apart(first, second);
}

/// Two edges from one point: they meet again only where one lies on the other.
void Cutter::test_sharing(int first, int second, int shared) {
  const auto other_end = [&](const RingEdge& e) { return e.from == shared ? e.to : e.from; };
  const int a = other_end(edge(first));
  const int b = other_end(edge(second));
  const Point2& corner = set_.point(shared);
  if (orientation(corner, set_.point(a), set_.point(b)) != 0) return;
  cut_if_between(first, b);
  cut_if_between(second, a);
}

void Cutter::test_apart(int first, int second) {
  const RingEdge e = edge(first);
  const RingEdge f = edge(second);
  const Point2& a = set_.point(e.from);
  const Point2& b = set_.point(e.to);
  const Point2& c = set_.point(f.from);
  const Point2& d = set_.point(f.to);
  const int c_side = orientation(a, b, c);
  const int d_side = orientation(a, b, d);
  if (c_side * d_side > 0) return;
  const int a_side = orientation(c, d, a);
  const int b_side = orientation(c, d, b);
  if (a_side * b_side > 0) return;
  if (c_side * d_side < 0 && a_side * b_side < 0) {
    const int point = numbers_.number_of(crossing(first, second));
    if (point != e.from && point != e.to) cuts_.push_back({first, point, false});
    if (point != f.from && point != f.to) cuts_.push_back({second, point, false});
    return;
  }
  if (c_side == 0) cut_if_between(first, f.from);
  if (d_side == 0) cut_if_between(first, f.to);
  if (a_side == 0) cut_if_between(second, e.from);
  if (b_side == 0) cut_if_between(second, e.to);
}

void Cutter::cut_if_between(int index, int point) {
  const Point2& a = set_.point(edge(index).from);
  const Point2& b = set_.point(edge(index).to);
  const Point2& p = set_.point(point);
  const bool is_between = a.x() != b.x() ? (a.x() < p.x()) == (p.x() < b.x()) && p.x() != b.x()
                                         : (a.y() < p.y()) == (p.y() < b.y()) && p.y() != b.y();
  if (is_between && p != a) cuts_.push_back({index, point, true});
}

/// Where the inner parts of two edges cross, on the fine grid. The same edges give the same point,
/// whichever way they run and in whichever order.
Point2 Cutter::crossing(int first, int second) const {
  const auto ordered = [&](int index) {
    const RingEdge& e = edge(index);
    return e.from < e.to ? std::pair(e.from, e.to) : std::pair(e.to, e.from);
  };
  const auto [along, across] = std::minmax({ordered(first), ordered(second)});
  const Point2& a = set_.point(along.first);
  const Point2& c = set_.point(across.first);
  const Point2 ab = set_.point(along.second) - a;
  const Point2 cd = set_.point(across.second) - c;
  const double fraction = std::clamp(cross(c - a, cd) / cross(ab, cd), 0.0, 1.0);
  return on_fine_grid(a + fraction * ab, set_.fine);
}

void Cutter::apply_cuts() {
  std::sort(cuts_.begin(), cuts_.end(), [&](const Cut& p, const Cut& q) {
    if (p.edge != q.edge) return p.edge < q.edge;
    const RingEdge& e = edge(p.edge);
    const Point2& start = set_.point(e.from);
    const Point2 along = set_.point(e.to) - start;
    const double at_p = (set_.point(p.point) - start).dot(along);
    const double at_q = (set_.point(q.point) - start).dot(along);
    return at_p != at_q ? at_p < at_q : p.point < q.point;
  });
  std::fill(is_fresh_.begin(), is_fresh_.end(), char{0});
  for (std::size_t i = 0; i < cuts_.size();) {
    const auto index = static_cast<std::size_t>(cuts_[i].edge);
    const RingEdge whole = set_.edges[index];
    std::size_t end = i;
    bool is_bent = false;
    for (; end < cuts_.size() && cuts_[end].edge == cuts_[i].edge; ++end) {
      is_bent = is_bent || !cuts_[end].is_exact;
    }
    is_fresh_[index] = is_bent ? 1 : 0;
    int from = whole.from;
    bool is_first = true;
    const auto add = [&](int to) {
      if (to == from) return;
      if (is_first) {
        set_.edges[index].to = to;
      } else {
        set_.edges.push_back({from, to, whole.ring});
        is_fresh_.push_back(is_bent ? 1 : 0);
      }
      is_first = false;
      from = to;
    };
    for (; i < end; ++i) add(cuts_[i].point);
    add(whole.to);
  }
}

}  // namespace

EdgeSet cut_where_they_meet(EdgeSet set) {
  Cutter cutter(set);
  for (int round = 0; round < kMaxRounds; ++round) {
    if (!cutter.cut_once()) return set;
  }
  return cut_by_snap_rounding(set);
}

}  // namespace roomatlas::planar
