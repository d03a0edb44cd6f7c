// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/merge/regular_walls.hpp"

#include "heal.hpp"
#include "wall_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace roomatlas {
namespace {

constexpr double kQuarter_rad = kPi / 2.0;
constexpr std::size_t kBins = 360;         // of a quarter turn: 0.25 degrees each
constexpr std::size_t kSmoothing = 6;      // bins to each side
constexpr double kMoveOverDistance = 1.5;  // of a corner, whose two walls both moved
constexpr double kMaxAreaChange = 0.1;     // share of a ring's area; more is no straightening

template <typename Visit>
void for_each_edge(const Ring& ring, Visit visit) {
  for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
}

template <typename Visit>
void for_each_ring(const std::vector<PlacedOutline>& outlines, Visit visit) {
  for (const PlacedOutline& placed : outlines) {
    visit(placed.outline.outer);
    for (const Ring& hole : placed.outline.holes) visit(hole);
  }
}

/// Angle modulo a quarter turn, [0, pi/2).
double quarter_angle(const Point2& along) {
  const double angle = std::fmod(std::atan2(along.y(), along.x()) + 2.0 * kPi, kQuarter_rad);
  return angle < kQuarter_rad ? angle : 0.0;
}

/// Signed difference modulo a quarter turn, at most an eighth turn.
double quarter_difference(double a, double b) { return std::remainder(a - b, kQuarter_rad); }

/// Length of edges over their direction modulo a quarter turn.
class Histogram {
 public:
  void add(const Point2& along) {
    angles_.push_back({quarter_angle(along), along.norm()});
    total_m_ += along.norm();
  }
  [[nodiscard]] double total_m() const { return total_m_; }
  /// The mean of the edges about the smoothed maximum, without those near the given directions.
  struct Peak {
    double angle_rad = 0.0;
    double length_m = 0.0;
  };
  [[nodiscard]] std::optional<Peak> strongest(const std::vector<double>& taken,
                                              double apart_rad) const;

 private:
  struct Entry {
    double angle_rad;
    double length_m;
  };
  std::vector<Entry> angles_;
  double total_m_ = 0.0;
};

std::optional<Histogram::Peak> Histogram::strongest(const std::vector<double>& taken,
                                                    double apart_rad) const {
  std::array<double, kBins> bins{};
  std::vector<Entry> free;
  for (const Entry& entry : angles_) {
    const bool is_free = std::none_of(taken.begin(), taken.end(), [&](double direction) {
      return std::abs(quarter_difference(entry.angle_rad, direction)) <= apart_rad;
    });
    if (!is_free) continue;
    free.push_back(entry);
    const auto bin = static_cast<std::size_t>(entry.angle_rad / kQuarter_rad * kBins);
    bins[std::min(bin, kBins - 1)] += entry.length_m;
  }
  std::size_t best = 0;
  double most = 0.0;
  for (std::size_t centre = 0; centre < kBins; ++centre) {
    double sum = 0.0;
    for (std::size_t k = 0; k <= 2 * kSmoothing; ++k) {
      const double weight = static_cast<double>(kSmoothing + 1) -
                            std::abs(static_cast<double>(k) - static_cast<double>(kSmoothing));
      sum += weight * bins[(centre + k + kBins - kSmoothing) % kBins];
    }
    if (sum <= most) continue;
    most = sum;
    best = centre;
  }
  if (most <= 0.0) return std::nullopt;
  const double bin_rad = kQuarter_rad / kBins;
  const double about = (static_cast<double>(best) + 0.5) * bin_rad;
  Peak peak;
  double shift = 0.0;
  for (const Entry& entry : free) {
    const double off = quarter_difference(entry.angle_rad, about);
    if (std::abs(off) > bin_rad * kSmoothing) continue;
    shift += off * entry.length_m;
    peak.length_m += entry.length_m;
  }
  if (peak.length_m <= 0.0) return std::nullopt;
  peak.angle_rad = std::fmod(about + shift / peak.length_m + kQuarter_rad, kQuarter_rad);
  return peak;
}

/// The edge as one that follows a direction, if it may.
std::optional<RegularEdge> regular_edge(const Point2& a, const Point2& b,
                                        const std::vector<double>& directions,
                                        const RegularWallOptions& options) {
  if ((b - a).norm() < options.min_wall_m) return std::nullopt;
  const double heading = std::atan2(b.y() - a.y(), b.x() - a.x());
  for (std::size_t d = 0; d < directions.size(); ++d) {
    const double off = quarter_difference(heading, directions[d]);
    if (std::abs(off) > radians(options.max_turn_deg)) continue;
    const double quarters = std::round((heading - off - directions[d]) / kQuarter_rad);
    const int quarter = (static_cast<int>(quarters) % 4 + 4) % 4;
    RegularEdge edge{{a, b}, {}, static_cast<int>(d) * 4 + quarter};
    edge.line.along = direction(directions[d] + quarter * kQuarter_rad);
    edge.line.offset_m = edge.line.normal().dot((a + b) / 2.0);
    if (edge.line.distance(a) > options.max_distance_m) return std::nullopt;
    return edge;
  }
  return std::nullopt;
}

/// Whether the ring turns a little, the same way, at both ends of the edge: then it is part of a
/// curve.
bool is_in_curve(const Ring& ring, std::size_t edge) {
  const std::size_t count = ring.size();
  const auto along = [&](std::size_t i) { return Point2(ring[(i + 1) % count] - ring[i % count]); };
  const auto turn = [&](const Point2& in, const Point2& out) {
    return std::atan2(cross(in, out), in.dot(out));
  };
  const double before = turn(along(edge + count - 1), along(edge));
  const double after = turn(along(edge), along(edge + 1));
  const auto is_slight = [](double angle) {
    return std::abs(angle) > radians(4.0) && std::abs(angle) < radians(46.0);
  };
  return before * after > 0.0 && is_slight(before) && is_slight(after);
}

/// Which edges of a ring follow a direction: their numbers in a common list, or -1.
using EdgeNumbers = std::vector<int>;

EdgeNumbers regular_edges(const Ring& ring, const std::vector<double>& directions,
                          const RegularWallOptions& options, std::vector<RegularEdge>& edges) {
  EdgeNumbers numbers(ring.size(), -1);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (is_in_curve(ring, i)) continue;
    const auto edge = regular_edge(ring[i], ring[(i + 1) % ring.size()], directions, options);
    if (!edge) continue;
    numbers[i] = static_cast<int>(edges.size());
    edges.push_back(*edge);
  }
  return numbers;
}

/// Steps between walls on one line that are shorter than a wall: the line goes on over them.
void bridge_steps(const Ring& ring, EdgeNumbers& numbers, const std::vector<RegularEdge>& edges,
                  const RegularWallOptions& options) {
  const std::size_t count = ring.size();
  const EdgeNumbers found = numbers;
  for (std::size_t i = 0; i < count; ++i) {
    const int before = found[(i + count - 1) % count];
    const int after = found[(i + 1) % count];
    if (found[i] >= 0 || before < 0 || after < 0) continue;
    const WallLine& line = edges[static_cast<std::size_t>(before)].line;
    const WallLine& next = edges[static_cast<std::size_t>(after)].line;
    const bool is_one_line = line.along == next.along && line.offset_m == next.offset_m;
    const bool is_near = line.distance(ring[i]) <= options.max_distance_m &&
                         line.distance(ring[(i + 1) % count]) <= options.max_distance_m;
    if (is_one_line && is_near) numbers[i] = before;
  }
}

Ring regular_ring(const Ring& ring, EdgeNumbers numbers, const std::vector<RegularEdge>& edges,
                  const RegularWallOptions& options) {
  bridge_steps(ring, numbers, edges, options);
  std::vector<const WallLine*> lines;
  for (const int number : numbers) {
    lines.push_back(number < 0 ? nullptr : &edges[static_cast<std::size_t>(number)].line);
  }
  return ring_on_lines(ring, lines, kMoveOverDistance * options.max_distance_m);
}

bool is_acceptable(const Polygon& before, const Polygon& after) {
  const double change = std::abs(signed_area(after.outer) - signed_area(before.outer));
  return planar::is_simple(after) && change <= kMaxAreaChange * std::abs(signed_area(before.outer));
}

}  // namespace

std::vector<double> building_directions(const std::vector<PlacedOutline>& outlines,
                                        const RegularWallOptions& options) {
  Histogram histogram;
  for_each_ring(outlines, [&](const Ring& ring) {
    for_each_edge(ring, [&](const Point2& a, const Point2& b) {
      if ((b - a).norm() >= options.min_wall_m) histogram.add(b - a);
    });
  });
  std::vector<double> directions;
  while (const auto peak = histogram.strongest(directions, 2.0 * radians(options.max_turn_deg))) {
    const double least_m = options.min_direction_share * histogram.total_m();
    if (!directions.empty() && peak->length_m < least_m) break;
    directions.push_back(peak->angle_rad);
  }
  return directions;
}

RegularOutlines with_regular_walls(const std::vector<PlacedOutline>& outlines,
                                   const RegularWallOptions& options) {
  RegularOutlines result;
  result.directions_rad = building_directions(outlines, options);
  std::vector<RegularEdge> edges;
  std::vector<EdgeNumbers> numbers;
  for_each_ring(outlines, [&](const Ring& ring) {
    numbers.push_back(regular_edges(ring, result.directions_rad, options, edges));
    for_each_edge(ring, [&](const Point2& a, const Point2& b) { result.wall_m += (b - a).norm(); });
  });
  for (const RegularEdge& edge : edges) result.regular_m += edge.length_m();
  align(edges, options.max_distance_m, options.align_gap_m);
  std::size_t ring = 0;
  for (const PlacedOutline& placed : outlines) {
    PlacedOutline moved{placed.asr, placed.room, {}};
    moved.outline.outer = regular_ring(placed.outline.outer, numbers[ring++], edges, options);
    for (const Ring& hole : placed.outline.holes) {
      moved.outline.holes.push_back(regular_ring(hole, numbers[ring++], edges, options));
    }
    const bool is_moved = is_acceptable(placed.outline, moved.outline);
    if (!is_moved) ++result.kept;
    result.outlines.push_back(is_moved ? std::move(moved) : placed);
  }
  return result;
}

}  // namespace roomatlas
