// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "roomatlas/polyline/simplify.hpp"

namespace roomatlas {
namespace {

constexpr double kToleranceM = 0.1;  // of Douglas and Peucker's edges
constexpr double kMinFaceM = 0.6;    // shorter is a jamb or a piece of furniture
constexpr double kMinVoteM = 0.5;    // shorter faces say nothing about directions
constexpr double kFullVoteM = 3.0;   // from here on a face's vote grows with its length alone
constexpr double kFollowsRad = radians(12.0);  // this near to a direction a face follows it
constexpr double kOwnDirectionM = 1.5;         // a face this long may have a direction of its own
constexpr double kSampleM = 0.1;               // along a face
constexpr double kBehindM =
    0.03;                   // a face's wall is looked for this far behind it: thin walls count
constexpr int kBins = 360;  // of half a degree
constexpr double kSmoothingBins = 4.0;       // sigma: 2 degrees
constexpr double kMinPeakShare = 0.05;       // of the largest peak
constexpr double kRefineRad = radians(4.0);  // faces this near to a peak say where it is

double heading_of(const Segment2& face) {
  return std::atan2(face.b.y() - face.a.y(), face.b.x() - face.a.x());
}

/// What a heading lacks to a direction modulo 180 degrees, [-pi/2, pi/2).
double off_direction(double heading_rad, double direction_rad) {
  return wrap_angle(2.0 * (direction_rad - heading_rad)) / 2.0;
}

std::array<double, kBins> smoothed_votes(const std::vector<Segment2>& faces) {
  std::array<double, kBins> votes{};
  for (const Segment2& face : faces) {
    const double length_m = (face.b - face.a).norm();
    if (length_m < kMinVoteM) continue;
    const double turned = wrap_angle(2.0 * heading_of(face)) / 2.0 + kPi / 2.0;  // [0, pi)
    const int bin = static_cast<int>(turned / kPi * kBins) % kBins;
    votes[static_cast<std::size_t>(bin)] += length_m * std::min(length_m, kFullVoteM);
  }
  std::array<double, kBins> smoothed{};
  for (int i = 0; i < kBins; ++i) {
    for (int off = -12; off <= 12; ++off) {
      smoothed[static_cast<std::size_t>(i)] +=
          votes[static_cast<std::size_t>((i + off + kBins) % kBins)] *
          std::exp(-0.5 * std::pow(off / kSmoothingBins, 2));
    }
  }
  return smoothed;
}

/// The mean of the faces near a direction, long ones counting more.
double refined(double direction_rad, const std::vector<Segment2>& faces) {
  double sum = 0.0;
  double weight = 0.0;
  for (const Segment2& face : faces) {
    const double off = -off_direction(heading_of(face), direction_rad);
    const double length2 = (face.b - face.a).squaredNorm();
    if (std::abs(off) >= kRefineRad || length2 < kMinVoteM * kMinVoteM) continue;
    sum += length2 * off;
    weight += length2;
  }
  const double turned = direction_rad + (weight > 0.0 ? sum / weight : 0.0);
  return turned - kPi * std::floor(turned / kPi);
}

/// The boundary's corners: cut at two points far apart, each half simplified.
void add_edges(const Ring& ring, std::vector<Segment2>& edges) {
  if (ring.size() < 8) return;
  const auto farthest_from = [&](const Point2& point) {
    return std::max_element(ring.begin(), ring.end(),
                            [&](const Point2& a, const Point2& b) {
                              return (a - point).squaredNorm() < (b - point).squaredNorm();
                            }) -
           ring.begin();
  };
  const auto first = farthest_from(ring.front());
  Polyline closed(ring.begin() + first, ring.end());
  closed.insert(closed.end(), ring.begin(), ring.begin() + first);
  const auto opposite =
      std::max_element(closed.begin(), closed.end(), [&](const Point2& a, const Point2& b) {
        return (a - closed.front()).squaredNorm() < (b - closed.front()).squaredNorm();
      });
  const auto pinned = static_cast<std::size_t>(opposite - closed.begin());
  closed.push_back(closed.front());
  const std::vector<std::size_t> kept = douglas_peucker(closed, kToleranceM, {pinned});
  for (std::size_t i = 1; i < kept.size(); ++i) {
    edges.push_back({closed[kept[i - 1]], closed[kept[i]]});
  }
}

/// Whether walls stand behind most of an edge; the floor also ends where beams ended.
bool has_wall(const OpenFloor& floor, const Segment2& edge) {
  const Point2 way = edge.b - edge.a;
  const Point2 behind = kBehindM * Point2(way.y(), -way.x()).normalized();
  const int steps = std::max(1, static_cast<int>(way.norm() / kSampleM));
  int walls = 0;
  for (int k = 0; k <= steps; ++k) {
    if (floor.is_wall(edge.a + way * k / steps + behind)) ++walls;
  }
  return 2 * walls > steps;
}

}  // namespace

std::vector<double> wall_directions_rad(const std::vector<Segment2>& faces) {
  const std::array<double, kBins> votes = smoothed_votes(faces);
  const double largest = *std::max_element(votes.begin(), votes.end());
  std::vector<double> directions;
  for (std::size_t i = 0; i < kBins; ++i) {
    const double before = votes[(i + kBins - 1) % kBins];
    const double after = votes[(i + 1) % kBins];
    if (votes[i] < before || votes[i] <= after || votes[i] <= kMinPeakShare * largest) continue;
    directions.push_back(refined((static_cast<double>(i) + 0.5) / kBins * kPi - kPi / 2.0, faces));
  }
  std::sort(directions.begin(), directions.end());
  return directions;
}

std::vector<WallFace> find_wall_faces(const OpenFloor& floor) {
  std::vector<Segment2> edges;
  for (const CellBoundary& boundary : trace_boundaries(floor.open, floor.frame)) {
    add_edges(boundary.edge_midpoints, edges);
  }
  std::erase_if(edges, [&](const Segment2& edge) { return !has_wall(floor, edge); });
  const std::vector<double> directions = wall_directions_rad(edges);
  std::vector<WallFace> faces;
  for (const Segment2& edge : edges) {
    const double length_m = (edge.b - edge.a).norm();
    if (length_m < kMinFaceM) continue;
    const double heading_rad = heading_of(edge);
    double off_rad = kPi;
    for (const double candidate : directions) {
      const double off = off_direction(heading_rad, candidate);
      if (std::abs(off) < std::abs(off_rad)) off_rad = off;
    }
    const bool follows = std::abs(off_rad) < kFollowsRad;
    if (!follows && length_m < kOwnDirectionM) continue;
    faces.push_back({edge, follows ? heading_rad + off_rad : heading_rad});
  }
  return faces;
}

}  // namespace roomatlas
