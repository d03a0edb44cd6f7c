// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/locate/building_index.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "correlation.hpp"
#include "heading_candidates.hpp"
#include "roomatlas/core/for_each_index.hpp"

namespace roomatlas {
namespace {

constexpr float kBesideWall = 0.5F;    // of a wall's worth: half a cell is half a cell
constexpr float kWallOnFloor = -0.5F;  // more forgets that doors and chairs move
constexpr float kFloorOnWall = -0.5F;
constexpr std::size_t kPeaksAHeading = 60;

CellBox around(const CellBox& a, const CellBox& b) {
  if (a.count() == 0) return b;
  if (b.count() == 0) return a;
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y)}};
}

CellBox box_of(const FloorSketch& sketch) {
  CellBox box;
  bool is_first = true;
  const auto add = [&](const Point2& at) {
    const Cell cell = floor_cells().cell_of(at);
    if (is_first) box = {cell, cell};
    is_first = false;
    box.min = {std::min(box.min.x, cell.x), std::min(box.min.y, cell.y)};
    box.max = {std::max(box.max.x, cell.x + 1), std::max(box.max.y, cell.y + 1)};
  };
  for (const ScanPoint& wall : sketch.walls) add(wall.position);
  for (const Point2& at : sketch.floor) add(at);
  return box;
}

CorrelationPlane::Layers layers_of(const TileGrid<char>& walls, const TileGrid<char>& floor) {
  const CellBox seen = around(walls.box(), floor.box());
  const CellBox box{{seen.min.x - 1, seen.min.y - 1}, {seen.max.x + 1, seen.max.y + 1}};
  CorrelationPlane::Layers layers{Raster<float>(box), Raster<float>(box)};
  floor.for_each([&](const Cell& cell, char is_floor) {
    if (is_floor != 0) layers.on_wall[cell] = kWallOnFloor;
  });
  walls.for_each([&](const Cell& middle, char is_wall) {
    if (is_wall == 0) return;
    // A wall's own cell is seen as floor from the side: what both maps see so contradicts less.
    layers.on_floor[middle] = floor.at(middle) != 0 ? kFloorOnWall / 2.0F : kFloorOnWall;
    for_each_cell({{middle.x - 1, middle.y - 1}, {middle.x + 2, middle.y + 2}},
                  [&](const Cell& cell) {
                    float& value = layers.on_wall[cell];
                    value = std::max(value, cell == middle ? 1.0F : kBesideWall);
                  });
  });
  return layers;
}

CorrelationPlane::Query query_of(const FloorSketch& turned) {
  const CellBox box = box_of(turned);
  CorrelationPlane::Query query{Raster<float>(box), Raster<float>(box)};
  for (const Point2& at : turned.floor) query.floor[floor_cells().cell_of(at)] = 1.0F;
  for (const ScanPoint& wall : turned.walls) {
    query.wall[floor_cells().cell_of(wall.position)] = 1.0F;
    query.floor[floor_cells().cell_of(wall.position)] = 0.0F;
  }
  return query;
}

bool is_peak(const Raster<float>& scores, const Cell& at) {
  const float score = scores[at];
  bool overtops = true;
  for_each_cell({{at.x - 1, at.y - 1}, {at.x + 2, at.y + 2}}, [&](const Cell& cell) {
    const float other = scores.get(cell, -1.0F);
    const bool is_before = cell.y < at.y || (cell.y == at.y && cell.x < at.x);
    overtops = overtops && (is_before ? score > other : score >= other);
  });
  return overtops;
}

/// What of it lies near to the middle.
FloorSketch near_middle(const FloorSketch& sketch, double radius_m) {
  FloorSketch near;
  for (const ScanPoint& wall : sketch.walls) {
    if (wall.position.norm() <= radius_m) near.walls.push_back(wall);
  }
  for (const Point2& at : sketch.floor) {
    if (at.norm() <= radius_m) near.floor.push_back(at);
  }
  return near;
}

/// The middle of where the robot was; of the walls, without a path.
Pose2 middle_of(const FloorSketch& sketch) {
  Point2 sum = Point2::Zero();
  for (const Point2& at : sketch.path) sum += at;
  if (!sketch.path.empty()) sum /= static_cast<double>(sketch.path.size());
  return {sum.x(), sum.y(), 0.0};
}

/// The likeliest, none of them near to a likelier one.
template <typename Place, typename PoseOf>
std::vector<Place> apart(std::vector<Place> places, std::size_t most, const LocateOptions& options,
                         PoseOf pose_of) {
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.score > b.score; });
  std::vector<Place> kept;
  for (const Place& place : places) {
    if (kept.size() >= most) break;
    const bool is_known = std::any_of(kept.begin(), kept.end(), [&](const Place& better) {
      const Pose2& one = pose_of(better);
      const Pose2& other = pose_of(place);
      return (one.position() - other.position()).norm() < options.apart_m &&
             std::abs(degrees(wrap_angle(one.theta_rad - other.theta_rad))) < options.apart_deg;
    });
    if (!is_known) kept.push_back(place);
  }
  return kept;
}

}  // namespace

BuildingIndex::BuildingIndex(const FloorSketch& building_sketch, const LocateOptions& options)
    : options_(options), directions_(direction_histogram({})) {
  add(building_sketch);
}

BuildingIndex::~BuildingIndex() = default;

void BuildingIndex::add(const FloorSketch& sketch) {
  const std::vector<double> directions = direction_histogram(sketch.walls);
  std::transform(directions_.begin(), directions_.end(), directions.begin(), directions_.begin(),
                 std::plus<>());
  seen_.add(sketch);
  plane_ = std::make_unique<CorrelationPlane>(
      layers_of(seen_.known_walls(), seen_.known_floor()),
      static_cast<int>(std::ceil(options_.max_query_m / kFloorCellM)) + 3);
}

std::vector<BuildingIndex::Coarse> BuildingIndex::search(const FloorSketch& query,
                                                         double heading_rad) const {
  const Raster<float> scores = plane_->scores(query_of(moved(query, Pose2{0.0, 0.0, heading_rad})));
  const auto pose = [](const Coarse& peak) -> const Pose2& { return peak.pose; };
  std::vector<Coarse> peaks;
  for_each_cell(scores.domain, [&](const Cell& shift) {
    if (scores[shift] <= 0.0F || !is_peak(scores, shift)) return;
    peaks.push_back({{shift.x * kFloorCellM, shift.y * kFloorCellM, heading_rad}, scores[shift]});
  });
  return apart(std::move(peaks), kPeaksAHeading, options_, pose);
}

void BuildingIndex::judge(const FloorSketch& query, PlaceHypothesis& place) const {
  const PointTransform to(place.building_from_query);
  const PointTransform turn(Pose2{0.0, 0.0, place.building_from_query.theta_rad});
  double misfit = 0.0;
  for (const ScanPoint& wall : query.walls) {
    const Point2 at = to * wall.position;
    const std::optional<double> off_m =
        seen_.distance_to_wall(at, turn * wall.normal, options_.agree_m);
    if (off_m) {
      ++place.agreeing;
      misfit += 0.5 * (*off_m / options_.wall_sigma_m) * (*off_m / options_.wall_sigma_m);
    } else if (seen_.is_floor(at)) {
      ++place.contradicting;
    } else {
      ++place.unseen;
    }
  }
  for (const Point2& floor : query.floor) {
    if (seen_.has_wall_in(to * floor)) ++place.missing;
  }
  place.score = (options_.agree_weight * place.agreeing - misfit -
                 options_.contradict_weight * (place.contradicting + place.missing)) /
                options_.samples_alike;
}

PlaceHypothesis BuildingIndex::at(const FloorSketch& query, const Pose2& place) const {
  PlaceHypothesis judged;
  judged.building_from_query = place;
  judge(query, judged);
  return judged;
}

double BuildingIndex::share_on_floor(const FloorSketch& query, const Pose2& place) const {
  const PointTransform to(place);
  const auto on_floor = std::count_if(query.path.begin(), query.path.end(),
                                      [&](const Point2& at) { return seen_.is_floor(to * at); });
  return query.path.empty()
             ? 0.0
             : static_cast<double>(on_floor) / static_cast<double>(query.path.size());
}

PlaceHypothesis BuildingIndex::fit(const FloorSketch& query, const Pose2& guess) const {
  return at(query,
            align(seen_.faces(), query.walls, guess, std::nullopt, options_.align).map_from_points);
}

std::vector<PlaceHypothesis> BuildingIndex::find(const FloorSketch& query, int jobs) const {
  if (query.walls.empty()) return {};
  // Turned about its middle, so that half a degree moves nothing far.
  const Pose2 middle = middle_of(query);
  const FloorSketch centred =
      near_middle(moved(query, inverse(middle)), options_.max_query_m / 2.0);
  const std::vector<double> headings =
      heading_candidates(directions_, direction_histogram(centred.walls));
  const auto pose = [](const Coarse& peak) -> const Pose2& { return peak.pose; };
  std::vector<Coarse> all;
  for (const auto& peaks : results_of<std::vector<Coarse>>(
           headings.size(), jobs, [&](std::size_t i) { return search(centred, headings[i]); })) {
    all.insert(all.end(), peaks.begin(), peaks.end());
  }
  all = apart(std::move(all), static_cast<std::size_t>(options_.candidates), options_, pose);
  std::vector<PlaceHypothesis> places = results_of<PlaceHypothesis>(
      all.size(), jobs, [&](std::size_t i) { return fit(query, all[i].pose * inverse(middle)); });
  return apart(
      std::move(places), all.size(), options_,
      [](const PlaceHypothesis& place) -> const Pose2& { return place.building_from_query; });
}

}  // namespace roomatlas
