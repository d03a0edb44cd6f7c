// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>

#include "roomatlas/core/place_index.hpp"
#include "roomatlas/rooms/assign_rooms.hpp"

namespace roomatlas {
namespace {

constexpr double kLatticeM = 0.2;       // of points that tell shares of areas and paths; larger is
                                        // faster and misjudges small rooms
constexpr double kDoorwayReachM = 0.8;  // path nearer to a doorway tells little about the room
constexpr double kTellingPathM = 0.8;   // shorter paths tell nothing
constexpr double kWallReachM = 0.25;    // evidence for wall beside a jamb may be this far off
constexpr double kAskEveryM = 0.1;      // along the line beside a jamb, from there on

/// Sets of ASRs that belong together.
class SameSet {
 public:
  explicit SameSet(const std::vector<Asr>& asrs) {
    for (const Asr& asr : asrs) sets_.make_set(asr.id);
  }
  void join(AsrId a, AsrId b) { sets_.union_set(a, b); }
  [[nodiscard]] AsrId representative(AsrId id) { return sets_.find_set(id); }

 private:
  std::map<AsrId, std::size_t> ranks_;
  std::map<AsrId, AsrId> parents_;
  boost::disjoint_sets<boost::associative_property_map<std::map<AsrId, std::size_t>>,
                       boost::associative_property_map<std::map<AsrId, AsrId>>>
      sets_{boost::make_assoc_property_map(ranks_), boost::make_assoc_property_map(parents_)};
};

/// The walls of all ASRs where the correction puts them.
class PlacedWalls {
 public:
  PlacedWalls(const std::vector<Asr>& asrs, const Placement& placement) {
    for (const Asr& asr : asrs) {
      for (const WallPolyline& wall : asr.walls) {
        Polyline& line = walls_.emplace_back(transformed(placement.at(asr.id), wall.vertices_asr));
        index_.add(boxes_.size(), bounds(line));
        boxes_.push_back(bounds(line));
      }
    }
  }

  [[nodiscard]] bool has_wall_near(const Point2& point) const {
    for (const std::size_t i : index_.near(box_around(point, kWallReachM))) {
      if ((point.array() < boxes_[i].min.array() - kWallReachM).any() ||
          (point.array() > boxes_[i].max.array() + kWallReachM).any()) {
        continue;
      }
      for (std::size_t v = 1; v < walls_[i].size(); ++v) {
        if (distance({walls_[i][v - 1], walls_[i][v]}, point) <= kWallReachM) return true;
      }
    }
    return false;
  }

 private:
  std::vector<Polyline> walls_;
  std::vector<Box2> boxes_;
  PlaceIndex index_;
};

/// Share of the door line's continuation beside one jamb where a wall has been seen.
double wall_share(const PlacedWalls& walls, const Pose2& building_from_pivot, double width_m,
                  double side, const RoomOptions& options) {
  int seen = 0;
  int asked = 0;
  for (double off_m = kAskEveryM; off_m <= options.wall_beside_door_m; off_m += kAskEveryM) {
    ++asked;
    if (walls.has_wall_near(building_from_pivot * Point2(0.0, side * (width_m / 2.0 + off_m)))) {
      ++seen;
    }
  }
  return asked > 0 ? static_cast<double>(seen) / asked : 0.0;
}

/// How surely an opening separates rooms, [0, 1]: the poorer of the wall shares beside its jambs.
double separation(const PlacedWalls& walls, const Pose2& building_from_pivot, double width_m,
                  const RoomOptions& options) {
  return std::min(wall_share(walls, building_from_pivot, width_m, 1.0, options),
                  wall_share(walls, building_from_pivot, width_m, -1.0, options));
}

/// The separation of each crossing, named by the ASR behind it. Crossings of one doorway share
/// the best view that any of them had.
std::map<AsrId, double> separations(const std::vector<Asr>& asrs, const RoomGraph& graph,
                                    const Placement& placement, const RoomOptions& options) {
  const PlacedWalls walls(asrs, placement);
  std::map<AsrId, double> own;
  for (const Asr& asr : asrs) {
    for (const Exit& exit : asr.exits) {
      if (exit.is_entry || !exit.neighbor || !placement.contains(*exit.neighbor)) continue;
      const Pose2& pivot = placement.at(*exit.neighbor);  // where the ASR behind it begins
      own[*exit.neighbor] =
          exit.kind == PassageKind::doorway ? separation(walls, pivot, exit.width_m, options) : 0.0;
    }
  }
  SameSet same_doorway(asrs);
  for (const PassageEdge& edge : graph.edges) {
    if (edge.source == EdgeSource::recognised) same_doorway.join(edge.from, edge.to);
  }
  std::map<AsrId, double> best;
  for (const auto& [to, value] : own) {
    double& of_group = best[same_doorway.representative(to)];
    of_group = std::max(of_group, value);
  }
  for (auto& [to, value] : own) value = best[same_doorway.representative(to)];
  return own;
}

void join_driven(SameSet& same, const std::vector<Asr>& asrs, const RoomGraph& graph,
                 const Placement& placement, const RoomOptions& options) {
  const std::map<AsrId, double> separation_of = separations(asrs, graph, placement, options);
  for (const PassageEdge& edge : graph.edges) {
    if (edge.source == EdgeSource::driven && separation_of.at(edge.to) < options.min_wall_share) {
      same.join(edge.from, edge.to);
    }
  }
}

/// Both edges of a recognised doorway begin behind it; the ASR before each is the one driven from.
void join_recognised(SameSet& same, const RoomGraph& graph) {
  std::map<AsrId, AsrId> driven_from;
  for (const PassageEdge& edge : graph.edges) {
    if (edge.source == EdgeSource::driven) driven_from[edge.to] = edge.from;
  }
  for (const PassageEdge& edge : graph.edges) {
    if (edge.source != EdgeSource::recognised) continue;
    const bool is_same_way = std::abs(edge.from_from_to.theta_rad) < kPi / 2.0;
    same.join(edge.from, is_same_way ? edge.to : driven_from.at(edge.to));
    same.join(driven_from.at(edge.from), is_same_way ? driven_from.at(edge.to) : edge.to);
  }
}

/// An ASR where the correction puts it.
struct PlacedAsr {
  AsrId id = 0;
  Polygon outline;
  Polyline path;  // thinned, without what lies in doorways: there, placement decides the side
  Box2 box;
};

bool is_near_doorway(const Asr& asr, const Point2& point_asr) {
  return std::any_of(asr.exits.begin(), asr.exits.end(), [&](const Exit& exit) {
    return exit.kind == PassageKind::doorway &&
           (exit.frame_from_pivot.position() - point_asr).norm() < kDoorwayReachM;
  });
}

PlacedAsr placed(const Asr& asr, const Pose2& building_from_asr) {
  PlacedAsr result{asr.id, transformed(building_from_asr, asr.outline_asr), {}, {}};
  for (const PathSample& sample : asr.path) {
    if (is_near_doorway(asr, sample.asr_from_robot.position())) continue;
    const Point2 at = building_from_asr * sample.asr_from_robot.position();
    if (result.path.empty() || (at - result.path.back()).norm() >= kLatticeM) {
      result.path.push_back(at);
    }
  }
  result.box = bounds(result.outline.outer);
  return result;
}

/// Share of a path that lies in an outline; 0 for a path too short to tell.
double share_inside(const Polyline& path, const Polygon& outline) {
  const auto inside = std::count_if(path.begin(), path.end(),
                                    [&](const Point2& at) { return contains(outline, at); });
  const bool is_long_enough = static_cast<double>(path.size()) * kLatticeM >= kTellingPathM;
  return is_long_enough ? static_cast<double>(inside) / static_cast<double>(path.size()) : 0.0;
}

bool is_same_place(const PlacedAsr& a, const PlacedAsr& b, const RoomOptions& options) {
  if ((a.box.min.array() > b.box.max.array()).any() ||
      (b.box.min.array() > a.box.max.array()).any()) {
    return false;
  }
  return overlap_share(a.outline, b.outline) >= options.min_overlap_share ||
         share_inside(a.path, b.outline) >= options.min_path_share ||
         share_inside(b.path, a.outline) >= options.min_path_share;
}

void join_overlapping(SameSet& same, const std::vector<Asr>& asrs, const Placement& placement,
                      const RoomOptions& options) {
  std::vector<PlacedAsr> all;
  PlaceIndex index;
  for (const Asr& asr : asrs) {
    all.push_back(placed(asr, placement.at(asr.id)));
    index.add(all.size() - 1, all.back().box);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const std::size_t j : index.near(all[i].box)) {
      if (j <= i) continue;
      if (same.representative(all[i].id) == same.representative(all[j].id)) continue;
      if (is_same_place(all[i], all[j], options)) same.join(all[i].id, all[j].id);
    }
  }
}

}  // namespace

double overlap_share(const Polygon& first, const Polygon& second) {
  const bool first_is_smaller = area(first) <= area(second);
  const Polygon& smaller = first_is_smaller ? first : second;
  const Polygon& larger = first_is_smaller ? second : first;
  const Box2 box = bounds(smaller.outer);
  if (box.empty() || larger.outer.empty()) return 0.0;
  int inside = 0;
  int shared = 0;
  for (double x = box.min.x() + kLatticeM / 2.0; x < box.max.x(); x += kLatticeM) {
    for (double y = box.min.y() + kLatticeM / 2.0; y < box.max.y(); y += kLatticeM) {
      if (!contains(smaller, Point2(x, y))) continue;
      ++inside;
      if (contains(larger, Point2(x, y))) ++shared;
    }
  }
  return inside > 0 ? static_cast<double>(shared) / inside : 0.0;
}

std::map<AsrId, RoomId> assign_rooms(const std::vector<Asr>& asrs, const RoomGraph& graph,
                                     const Placement& placement, const RoomOptions& options) {
  SameSet same(asrs);
  join_driven(same, asrs, graph, placement, options);
  join_recognised(same, graph);
  join_overlapping(same, asrs, placement, options);

  std::map<AsrId, RoomId> number_of;  // by representative
  std::map<AsrId, RoomId> room_of;
  for (const Asr& asr : asrs) {
    const auto next = static_cast<RoomId>(number_of.size() + 1);
    room_of[asr.id] = number_of.try_emplace(same.representative(asr.id), next).first->second;
  }
  return room_of;
}

}  // namespace roomatlas
