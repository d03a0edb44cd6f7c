// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/edges.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace roomatlas {
namespace {

constexpr double kEdgeStep_m = 0.05;  // between places on an edge
constexpr double kNear_m = 0.08;      // from an edge to an obstacle that is its wall
constexpr double kShortest_m = 0.3;   // shorter stretches say what their neighbours say
constexpr double kOnLine_m = 0.03;    // from a wall's line, on it
constexpr double kOnLineSine = 0.05;
constexpr double kReading_m = 0.1;  // surfaces this near an edge are of its wall ...
constexpr double kReadingTurn_rad = 30.0 * kPi / 180.0;  // ... when they look its way

/// Surfaces in buckets, so that those near an edge are found.
class SurfaceIndex {
 public:
  explicit SurfaceIndex(const std::vector<SurfacePoint>& surfaces) {
    for (const SurfacePoint& surface : surfaces) buckets_[bucket(surface.at)].push_back(&surface);
  }

  /// The mean distance of surfaces from a stretch that looks along `normal_rad`.
  [[nodiscard]] std::optional<double> deviation_m(const Segment2& line, double normal_rad) const {
    double sum = 0.0;
    double weights = 0.0;
    const auto low = bucket(line.a.cwiseMin(line.b) - Point2::Constant(kReading_m));
    const auto high = bucket(line.a.cwiseMax(line.b) + Point2::Constant(kReading_m));
    for (int x = low.first; x <= high.first; ++x) {
      for (auto at = buckets_.lower_bound({x, low.second});
           at != buckets_.end() && at->first <= std::pair(x, high.second); ++at) {
        for (const SurfacePoint* surface : at->second) {
          if (std::abs(wrap_angle(surface->normal_rad - normal_rad)) > kReadingTurn_rad) continue;
          const double off_m = distance(line, surface->at);
          if (off_m > kReading_m) continue;
          sum += surface->weight * off_m;
          weights += surface->weight;
        }
      }
    }
    if (weights <= 0.0) return std::nullopt;
    return sum / weights;
  }

 private:
  static std::pair<int, int> bucket(const Point2& at) {
    return {static_cast<int>(std::floor(at.x() / 0.5)), static_cast<int>(std::floor(at.y() / 0.5))};
  }
  std::map<std::pair<int, int>, std::vector<const SurfacePoint*>> buckets_;
};

bool is_on_wall_line(const Segment2& edge, const Walls& walls) {
  const Point2 along = (edge.b - edge.a).normalized();
  const Point2 middle = (edge.a + edge.b) / 2.0;
  return std::any_of(walls.faces.begin(), walls.faces.end(), [&](const WallFace& face) {
    return std::abs(face.normal().dot(along)) < kOnLineSine &&
           std::abs(face.normal().dot(middle) - face.offset_m) < kOnLine_m;
  });
}

bool is_obstacle_near(const Point2& at, const Occupancy& occupancy) {
  const int reach = static_cast<int>(std::ceil(kNear_m / occupancy.frame.cell_m));
  const Cell center = occupancy.frame.cell_of(at);
  bool found = false;
  for_each_cell(
      {{center.x - reach, center.y - reach}, {center.x + reach + 1, center.y + reach + 1}},
      [&](const Cell& cell) {
        found = found ||
                (occupancy.obstacle.at(cell) && (occupancy.frame.center_of(cell) - at).norm() <=
                                                    kNear_m + occupancy.frame.cell_m / 2.0);
      });
  return found;
}

/// Runs of places that say the same; short ones join the one before.
std::vector<std::pair<int, bool>> runs_of(const std::vector<bool>& is_measured, int shortest) {
  std::vector<std::pair<int, bool>> runs;  // places, answer
  for (const bool measured : is_measured) {
    if (!runs.empty() && runs.back().second == measured) {
      ++runs.back().first;
    } else {
      runs.emplace_back(1, measured);
    }
  }
  for (std::size_t i = 0; runs.size() > 1 && i < runs.size();) {
    if (runs[i].first >= shortest) {
      ++i;
      continue;
    }
    const std::size_t into = i > 0 ? i - 1 : 1;
    runs[into].first += runs[i].first;
    runs.erase(runs.begin() + static_cast<std::ptrdiff_t>(i));
    i = into;
    if (i + 1 < runs.size() && runs[i + 1].second == runs[i].second) {
      runs[i].first += runs[i + 1].first;
      runs.erase(runs.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    }
  }
  return runs;
}

class EdgeJudge {
 public:
  EdgeJudge(const Walls& walls, const BuildingEvidence& evidence, const Occupancy& occupancy)
      : walls_(walls), occupancy_(occupancy), surfaces_(evidence.surfaces) {}

  void add(RoomId room, const Ring& ring, std::vector<PlanEdge>& edges) const {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      add_side(room, {ring[i], ring[(i + 1) % ring.size()]}, edges);
    }
  }

 private:
  void add_side(RoomId room, const Segment2& side, std::vector<PlanEdge>& edges) const {
    const Point2 way = side.b - side.a;
    const int count = std::max(1, static_cast<int>(way.norm() / kEdgeStep_m));
    std::vector<bool> is_measured;
    is_measured.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
      is_measured.push_back(is_obstacle_near(side.a + way * ((i + 0.5) / count), occupancy_));
    }
    const bool is_on_line = is_on_wall_line(side, walls_);
    const double normal_rad = std::atan2(way.y(), way.x()) + kPi / 2.0;
    int done = 0;
    for (const auto& [places, measured] :
         runs_of(is_measured, static_cast<int>(kShortest_m / kEdgeStep_m))) {
      PlanEdge edge;
      edge.room = room;
      edge.line = {side.a + way * (static_cast<double>(done) / count),
                   side.a + way * (static_cast<double>(done + places) / count)};
      edge.evidence = measured     ? WallEvidence::measured
                      : is_on_line ? WallEvidence::inferred
                                   : WallEvidence::unexplored;
      if (measured) edge.deviation_m = surfaces_.deviation_m(edge.line, normal_rad);
      edges.push_back(edge);
      done += places;
    }
  }

  const Walls& walls_;
  const Occupancy& occupancy_;
  SurfaceIndex surfaces_;
};

}  // namespace

std::vector<PlanEdge> edges_of(const std::vector<DraftedRoom>& rooms, const Walls& walls,
                               const BuildingEvidence& evidence, const Occupancy& occupancy) {
  const EdgeJudge judge(walls, evidence, occupancy);
  std::vector<PlanEdge> edges;
  for (const DraftedRoom& room : rooms) {
    judge.add(room.id, room.outline.outer, edges);
    for (const Ring& hole : room.outline.holes) judge.add(room.id, hole, edges);
  }
  return edges;
}

}  // namespace roomatlas
