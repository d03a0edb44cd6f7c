// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/merge/unexplored.hpp"

#include <algorithm>
#include <cmath>

#include "nearby_segments.hpp"

namespace roomatlas {
namespace {

constexpr double kStep_m = 0.1;         // between the places that are tried
constexpr double kStart_m = 0.02;       // a probe starts so far outside, to be off its own edge
constexpr double kStraightSine = 1e-6;  // a vertex that turns by no more is on a line

/// A short piece of a ring, and whether free space ends there without a wall.
struct Piece {
  Point2 begin;
  Point2 end;
  bool is_unexplored = false;
};

/// What the pieces are judged by.
struct Known {
  NearbySegments walls;       ///< and doors
  NearbySegments boundaries;  ///< of free space
  UnexploredOptions options;

  [[nodiscard]] bool is_unexplored(const Piece& piece) const {
    const Point2 middle = (piece.begin + piece.end) / 2.0;
    if (walls.is_near(middle, options.reach_m)) return false;
    const Point2 along = (piece.end - piece.begin).normalized();
    const Point2 outwards(along.y(), -along.x());
    return !boundaries.crosses(
        {middle + kStart_m * outwards, middle + options.thickest_wall_m * outwards});
  }
};

/// The ring in pieces, with free space to their left.
std::vector<Piece> pieces_of(const Ring& ring, const Known& known) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[i];
    const Point2 along = ring[(i + 1) % ring.size()] - a;
    const int steps = std::max(1, static_cast<int>(std::ceil(along.norm() / kStep_m)));
    if (along.norm() == 0.0) continue;
    for (int k = 0; k < steps; ++k) {
      Piece piece{a + along * (static_cast<double>(k) / steps),
                  a + along * (static_cast<double>(k + 1) / steps)};
      piece.is_unexplored = known.is_unexplored(piece);
      pieces.push_back(piece);
    }
  }
  return pieces;
}

/// Leaves out what lies between two vertices on one line.
Polyline without_steps(const Polyline& line) {
  Polyline kept;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == line.size();
    if (is_end || std::abs(cross((line[i] - kept.back()).normalized(),
                                 (line[i + 1] - line[i]).normalized())) > kStraightSine) {
      kept.push_back(line[i]);
    }
  }
  return kept;
}

/// Runs of unexplored pieces around a ring, wherever its first vertex is.
void add_runs(const std::vector<Piece>& pieces, double shortest_m, std::vector<Polyline>& runs) {
  const auto seen = std::find_if(pieces.begin(), pieces.end(),
                                 [](const Piece& piece) { return !piece.is_unexplored; });
  const bool is_whole_ring = seen == pieces.end();
  const std::size_t start =
      is_whole_ring ? 0 : static_cast<std::size_t>(std::distance(pieces.begin(), seen));
  Polyline run;
  const auto finish = [&] {
    if (length(run) >= shortest_m) runs.push_back(without_steps(run));
    run.clear();
  };
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& piece = pieces[(start + i) % pieces.size()];
    if (!piece.is_unexplored) {
      finish();
      continue;
    }
    if (run.empty()) run.push_back(piece.begin);
    run.push_back(piece.end);
  }
  finish();
}

}  // namespace

std::vector<Polyline> unexplored_boundary(const FloorPlan& plan,
                                          const std::vector<Polyline>& walls_seen,
                                          const UnexploredOptions& options) {
  Known known;
  known.options = options;
  for (const Polyline& wall : walls_seen) known.walls.add_line(wall);
  for (const PlanDoor& door : plan.doors) {
    known.walls.add(door.jambs);
    known.walls.add_ring(door.opening);
  }
  for (const Polygon& polygon : plan.free_space) {
    known.boundaries.add_ring(polygon.outer);
    for (const Ring& hole : polygon.holes) known.boundaries.add_ring(hole);
  }
  std::vector<Polyline> runs;
  for (const Polygon& polygon : plan.free_space) {
    add_runs(pieces_of(polygon.outer, known), options.shortest_m, runs);
    for (const Ring& hole : polygon.holes) {
      add_runs(pieces_of(hole, known), options.shortest_m, runs);
    }
  }
  return runs;
}

}  // namespace roomatlas
