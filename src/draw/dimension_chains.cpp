// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draw/dimensions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace roomatlas {
namespace {

constexpr double kStep_m = 0.3;  // by which an outline steps at a wall that counts
constexpr double kSquare_sine =
    0.0872;                           // 5 degrees: a short face so near to a right angle counts ...
constexpr double kLongSine = 0.0262;  // ... and a long one within 1.5 degrees
constexpr double kSame_m = 0.03;      // stations nearer than this are one
constexpr double kTouch_m = 0.05;     // faces that miss each other by less belong together
constexpr double kThickest_m = 0.7;   // of an outside wall
constexpr double kNothing = -std::numeric_limits<double>::infinity();

/// One side of the building as seen from outside: `u` runs along the chain, `d` outwards.
struct Side {
  Point2 along;
  Point2 outwards;
  [[nodiscard]] Point2 operator()(const Point2& point) const {
    return {along.dot(point), outwards.dot(point)};
  }
};

/// Whether an edge stands at a right angle to the chain.
bool stands_square(const Point2& edge) {
  const double run = std::abs(edge.x());
  return run <= kLongSine * edge.norm() || (run <= kSame_m && run <= kSquare_sine * edge.norm());
}

struct Edge {
  Point2 a;  ///< (u, d), a.x() <= b.x()
  Point2 b;

  [[nodiscard]] double depth_at(double u) const {
    const double run = b.x() - a.x();
    return run > 0.0 ? a.y() + (b.y() - a.y()) * (u - a.x()) / run : std::max(a.y(), b.y());
  }
  [[nodiscard]] bool is_face() const { return stands_square(b - a); }
  [[nodiscard]] double low() const { return std::min(a.y(), b.y()); }
  [[nodiscard]] double high() const { return std::max(a.y(), b.y()); }
};

/// The ring as seen from the side, its faces upright: a run of edges that are nearly at a right
/// angle to the chain gets the place of its longest edge.
Ring upright(const Ring& ring, const Side& side) {
  Ring seen;
  for (const Point2& point : ring) {
    if (point.allFinite()) seen.push_back(side(point));
  }
  const std::size_t size = seen.size();
  const auto edge = [&](std::size_t i) { return Point2(seen[(i + 1) % size] - seen[i % size]); };
  std::vector<bool> is_face;
  for (std::size_t i = 0; i < size; ++i) {
    is_face.push_back(stands_square(edge(i)));
  }
  const auto first = std::find(is_face.begin(), is_face.end(), false);
  if (first == is_face.end()) return seen;
  const auto start = static_cast<std::size_t>(first - is_face.begin());
  for (std::size_t i = start; i < start + size;) {
    std::size_t end = i;
    std::size_t longest = i;
    for (; is_face[end % size]; ++end) {
      if (edge(end).norm() > edge(longest).norm()) longest = end;
    }
    const double place = (seen[longest % size].x() + seen[(longest + 1) % size].x()) / 2.0;
    for (std::size_t k = i; end > i && k <= end; ++k) seen[k % size].x() = place;
    i = end + 1;
  }
  return seen;
}

void add_edges(const Ring& ring, const Side& side, std::vector<Edge>& edges) {
  const Ring seen = upright(ring, side);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    Edge edge{seen[i], seen[(i + 1) % seen.size()]};
    if (edge.a == edge.b) continue;
    if (edge.a.x() > edge.b.x()) std::swap(edge.a, edge.b);
    edges.push_back(edge);
  }
}

void sort_by_begin(std::vector<Edge>& edges) {
  std::sort(edges.begin(), edges.end(), [](const Edge& p, const Edge& q) {
    return std::tuple(p.a.x(), p.a.y(), p.b.x(), p.b.y()) <
           std::tuple(q.a.x(), q.a.y(), q.b.x(), q.b.y());
  });
}

/// What is seen of the rooms between two neighbouring vertices.
struct Slab {
  double begin = 0.0;
  double end = 0.0;
  double depth_begin = kNothing;  ///< of the outermost edge, at `begin` ...
  double depth_end = kNothing;    ///< ... and at `end`
};

/// @param edges sorted by where they begin
std::vector<Slab> skyline(const std::vector<Edge>& edges) {
  std::vector<double> cuts;
  for (const Edge& edge : edges) cuts.insert(cuts.end(), {edge.a.x(), edge.b.x()});
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  std::vector<Slab> slabs;
  std::vector<const Edge*> open;
  std::size_t next = 0;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    Slab slab{cuts[i], cuts[i + 1]};
    std::erase_if(open, [&](const Edge* edge) { return edge->b.x() <= slab.begin; });
    for (; next < edges.size() && edges[next].a.x() <= slab.begin; ++next) {
      if (edges[next].b.x() > slab.begin) open.push_back(&edges[next]);
    }
    const double middle = (slab.begin + slab.end) / 2.0;
    const auto outermost = std::max_element(
        open.begin(), open.end(),
        [&](const Edge* p, const Edge* q) { return p->depth_at(middle) < q->depth_at(middle); });
    if (outermost != open.end()) {
      slab.depth_begin = (*outermost)->depth_at(slab.begin);
      slab.depth_end = (*outermost)->depth_at(slab.end);
    }
    slabs.push_back(slab);
  }
  return slabs;
}

/// Whether a face stands where the outline steps between two depths.
bool has_face(const std::vector<Edge>& faces, double u, double from, double to) {
  const double low = std::min(from, to);
  const double high = std::max(from, to);
  return std::any_of(faces.begin(), faces.end(), [&](const Edge& face) {
    const bool is_here = face.a.x() - kTouch_m <= u && u <= face.b.x() + kTouch_m;
    return is_here && face.high() > high - kTouch_m - kStep_m && face.high() < high + kTouch_m &&
           face.high() > low && face.high() - face.low() >= kStep_m / 2.0;
  });
}

/// Where the outline seen from outside steps at a wall's face.
std::vector<double> stations_of(const std::vector<Edge>& edges) {
  std::vector<Edge> faces;
  for (const Edge& edge : edges) {
    if (edge.is_face()) faces.push_back(edge);
  }
  std::vector<double> stations;
  double before = kNothing;
  const auto step = [&](double u, double after) {
    const bool is_step = before != after && !(std::abs(before - after) < kStep_m);
    if (!is_step || !has_face(faces, u, before, after)) return;
    if (stations.empty() || u - stations.back() > kSame_m) stations.push_back(u);
  };
  for (const Slab& slab : skyline(edges)) {
    step(slab.begin, slab.depth_begin);
    before = slab.depth_end;
  }
  if (!edges.empty()) {
    double last = kNothing;
    for (const Edge& edge : edges) last = std::max(last, edge.b.x());
    step(last, kNothing);
  }
  return stations;
}

/// The wall's corner behind the outermost corner of the rooms: where no face ends the building,
/// such as at an arc. `u` itself where there is none.
double outer_corner(const std::vector<Edge>& rooms, const std::vector<Edge>& walls, double u,
                    double sign) {
  double depth = 0.0;
  double nearest = kTouch_m;
  for (const Edge& edge : rooms) {
    for (const Point2& corner : {edge.a, edge.b}) {
      if (std::abs(corner.x() - u) >= nearest) continue;
      nearest = std::abs(corner.x() - u);
      depth = corner.y();
    }
  }
  double best = u;
  double aside = kThickest_m / 2.0;  // of the corner behind from the one before
  for (const Edge& wall : walls) {
    for (const Point2& corner : {wall.a, wall.b}) {
      const double thickness = sign * (corner.x() - u);
      const bool is_behind = thickness > kSame_m / 2.0 && thickness <= kThickest_m;
      if (nearest == kTouch_m || !is_behind || std::abs(corner.y() - depth) >= aside) continue;
      aside = std::abs(corner.y() - depth);
      best = corner.x();
    }
  }
  return best;
}

/// The outer face of the wall behind the outermost face of the rooms, if there is one.
/// @param sign -1 at the chain's begin, 1 at its end
double outer_face(const std::vector<Edge>& rooms, const std::vector<Edge>& walls, double u,
                  double sign) {
  double best = u;
  for (const Edge& wall : walls) {
    if (!wall.is_face()) continue;
    const double at = (wall.a.x() + wall.b.x()) / 2.0;
    const double thickness = sign * (at - u);
    if (thickness < kSame_m / 2.0 || thickness > kThickest_m) continue;
    if (best != u && sign * (at - best) > 0.0) continue;  // a nearer one is known
    const bool is_behind = std::any_of(rooms.begin(), rooms.end(), [&](const Edge& face) {
      return face.is_face() && std::abs((face.a.x() + face.b.x()) / 2.0 - u) < kTouch_m &&
             face.low() - kTouch_m <= wall.high() && wall.low() <= face.high() + kTouch_m;
    });
    if (is_behind) best = at;
  }
  return best != u ? best : outer_corner(rooms, walls, u, sign);
}

std::optional<DimensionChain> chain_along(const Side& side,
                                          const std::vector<const PlanRoom*>& block,
                                          const std::vector<Polygon>& walls) {
  std::vector<Edge> of_rooms;
  for (const PlanRoom* room : block) {
    for (const Polygon& part : room->parts) add_edges(part.outer, side, of_rooms);
  }
  if (of_rooms.empty()) return std::nullopt;
  sort_by_begin(of_rooms);
  std::vector<Edge> of_walls;
  for (const Polygon& wall : walls) {
    add_edges(wall.outer, side, of_walls);
    for (const Ring& hole : wall.holes) add_edges(hole, side, of_walls);
  }
  std::vector<double> stations = stations_of(of_rooms);
  double first = of_rooms.front().a.x();
  double last = first;
  double outermost = kNothing;
  for (const Edge& edge : of_rooms) {
    last = std::max(last, edge.b.x());
    outermost = std::max(outermost, edge.high());
  }
  if (stations.empty() || stations.front() - first > kSame_m)
    stations.insert(stations.begin(), first);
  if (last - stations.back() > kSame_m) stations.push_back(last);
  const double begin = outer_face(of_rooms, of_walls, stations.front(), -1.0);
  const double end = outer_face(of_rooms, of_walls, stations.back(), 1.0);
  if (begin < stations.front()) stations.insert(stations.begin(), begin);
  if (end > stations.back()) stations.push_back(end);
  if (stations.size() < 2) return std::nullopt;
  DimensionChain chain;
  chain.along = side.along;
  chain.outwards = side.outwards;
  chain.origin = stations.front() * side.along + outermost * side.outwards;
  for (const double station : stations) chain.stations_m.push_back(station - stations.front());
  return chain;
}

}  // namespace

std::vector<DimensionChain> dimension_chains(const FloorPlan& plan) {
  const double direction_rad = main_direction_rad(plan);
  const Point2 right(std::cos(direction_rad), std::sin(direction_rad));
  const Point2 up(-right.y(), right.x());
  const std::vector<const PlanRoom*> block = main_block(plan, direction_rad);
  std::vector<DimensionChain> chains;
  for (const Side& side : {Side{right, -up}, Side{up, -right}}) {
    if (auto chain = chain_along(side, block, plan.walls)) chains.push_back(*std::move(chain));
  }
  return chains;
}

std::vector<std::int64_t> centimetres(const std::vector<double>& stations_m) {
  std::vector<std::int64_t> parts;
  const auto position = [&](std::size_t i) {
    return std::llround(100.0 * (stations_m[i] - stations_m.front()));
  };
  for (std::size_t i = 0; i + 1 < stations_m.size(); ++i) {
    parts.push_back(position(i + 1) - position(i));
  }
  return parts;
}

}  // namespace roomatlas
