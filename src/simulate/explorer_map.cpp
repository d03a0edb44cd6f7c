// SPDX-License-Identifier: GPL-3.0-or-later
#include "explorer_map.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace roomatlas {
namespace {

constexpr double kCellM = 0.05;            // a door's jambs leave room for the robot between them
constexpr double kObstacle = 5.0;          // C: two hits; one may be crosstalk
constexpr double kSonarHitM = 0.8;         // farther echoes are too vague: they would close doors
constexpr double kSonarNoEchoM = 0.5;      // a flat wall gives none
constexpr double kConeFreeM = 1.5;         // how far the whole cone counts as free
constexpr double kConeShare = 0.7;         // of the half cone
constexpr double kEchoClearanceM = 0.1;    // before an echo nothing is freed: its wall stays
constexpr double kLaserM = 5.0;            // how far a laser is mapped, echo or not
constexpr double kTouchingMarginM = 0.04;  // beyond the robot's half width
constexpr double kTurningMarginM = 0.05;   // beyond the robot's half diagonal
constexpr int kLookAroundCells = 2;  // how far a frontier looks for unknown cells, to each side
constexpr int kNarrowCells = 2;      // to each side
constexpr double kBesideM = 0.7;     // as far as jambs are from the middle of a door
constexpr int kFrontierUnknownCells = 6;  // of the 24 around; fewer may be specks between beams ...
constexpr int kGapUnknownCells = 3;       // ... unless they belong to something large:
constexpr std::size_t kLargeUnknownCells = 120;  // 0.3 m2

std::vector<Cell> disc(double radius_m) {
  const int reach = static_cast<int>(std::floor(radius_m / kCellM));
  std::vector<Cell> cells;
  for_each_cell({{-reach, -reach}, {reach + 1, reach + 1}}, [&](const Cell& cell) {
    if (std::hypot(cell.x, cell.y) * kCellM <= radius_m) cells.push_back(cell);
  });
  return cells;
}

CellBox square(const Cell& middle, int reach) {
  return {{middle.x - reach, middle.y - reach}, {middle.x + reach + 1, middle.y + reach + 1}};
}

RayOptions ray_options(SensorKind kind) {
  return {kind == SensorKind::laser ? kLaserM : kSonarHitM, kSonarNoEchoM, kLaserM};
}

/// The part of a ray that meets nothing known to stand there.
Ray up_to_obstacles(const HimmGrid& himm, const Ray& ray) {
  Point2 end = ray.segment.a;
  for_each_cell_on_line(himm.frame().cell_of(ray.segment.a), himm.frame().cell_of(ray.segment.b),
                        [&](const Cell& cell) {
                          if (himm.raw(cell) > 0) return false;
                          end = himm.frame().center_of(cell);
                          return true;
                        });
  return {{ray.segment.a, end}, false};
}

/// An echo says that the whole cone before it is free, not its axis alone. Beside the axis that is
/// believed of unknown floor, not against what was seen to stand there: a surface met at a flat
/// angle gives no echo.
void spread_over_cones(const HimmGrid& himm, const RangeReading& reading,
                       const Pose2& map_from_robot, std::vector<Ray>& rays) {
  const RangeSensor& sensor = *reading.sensor;
  for (std::size_t i = 0; i < reading.ranges_m.size(); ++i) {
    const double range_m = reading.ranges_m[i];
    if (!(range_m > kEchoClearanceM) || range_m >= sensor.max_range_m) continue;
    const Pose2 map_from_beam = map_from_robot * sensor.robot_from_beam[i];
    for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
      const Point2 along = direction(share * kConeShare * sensor.half_cone_rad);
      const double free_m = std::min(range_m - kEchoClearanceM, kConeFreeM);
      const Ray ray{{map_from_beam.position(), map_from_beam * Point2(free_m * along)}, false};
      rays.push_back(std::abs(share) < 1.0 && free_m < kSonarHitM ? ray
                                                                  : up_to_obstacles(himm, ray));
    }
  }
}

}  // namespace

ExplorerMap::ExplorerMap(const RobotFootprint& footprint)
    : footprint_(footprint),
      himm_(kCellM),
      touching_disc_(disc(footprint.width_m / 2.0 + kTouchingMarginM)),
      turning_disc_(
          disc(std::hypot(footprint.length_m, footprint.width_m) / 2.0 + kTurningMarginM)) {}

void ExplorerMap::add(const RangeReading& reading, const Pose2& map_from_robot) {
  std::int64_t ignored = 0;
  const SensorKind kind = reading.sensor->kind;
  std::vector<Ray> rays = rays_of(reading, map_from_robot, ray_options(kind), ignored);
  if (kind == SensorKind::sonar) spread_over_cones(himm_, reading, map_from_robot, rays);
  himm_.mark_robot(map_from_robot, footprint_);
  himm_.add_sweep(rays);
  grow();
  for (const Ray& ray : rays) {
    const Cell to = frame().cell_of(ray.segment.b);
    for_each_cell_on_line(frame().cell_of(ray.segment.a), to, [&](const Cell& cell) {
      update(cell);
      return true;
    });
    if (!ray.ends_at_obstacle) continue;
    for_each_cell({{to.x - 1, to.y - 1}, {to.x + 2, to.y + 2}},
                  [&](const Cell& cell) { update(cell); });
  }
}

/// Follows the grid's box.
void ExplorerMap::grow() {
  const CellBox& box = himm_.box();
  if (box.min == box_.min && box.max == box_.max) return;
  std::vector<Nearness> grown(box.count());
  for_each_cell(
      box_, [&](const Cell& cell) { grown[box.index_of(cell)] = nearness_[box_.index_of(cell)]; });
  nearness_ = std::move(grown);
  box_ = box;
}

void ExplorerMap::update(const Cell& cell) {
  if (!box_.contains(cell)) return;
  Nearness& here = nearness_[box_.index_of(cell)];
  const bool is_obstacle = himm_.value(cell) >= kObstacle;
  if (is_obstacle == here.is_obstacle) return;
  here.is_obstacle = is_obstacle;
  const auto count = [&](const std::vector<Cell>& offsets, std::uint16_t Nearness::*member) {
    for (const Cell& offset : offsets) {
      const Cell at{cell.x + offset.x, cell.y + offset.y};
      if (!box_.contains(at)) continue;
      std::uint16_t& number = nearness_[box_.index_of(at)].*member;
      number = static_cast<std::uint16_t>(is_obstacle ? number + 1 : number - 1);
    }
  };
  count(touching_disc_, &Nearness::touching);
  count(turning_disc_, &Nearness::turning);
}

const ExplorerMap::Nearness* ExplorerMap::nearness(const Cell& cell) const {
  return box_.contains(cell) ? &nearness_[box_.index_of(cell)] : nullptr;
}

bool ExplorerMap::is_obstacle(const Cell& cell) const {
  const Nearness* here = nearness(cell);
  return here != nullptr && here->is_obstacle;
}

bool ExplorerMap::is_passable(const Cell& cell) const {
  const Nearness* here = nearness(cell);
  return here != nullptr && here->touching == 0 && himm_.raw(cell) < 0;
}

bool ExplorerMap::is_tight(const Cell& cell) const {
  const Nearness* here = nearness(cell);
  return here != nullptr && here->turning > 0;
}

bool ExplorerMap::is_frontier(const Cell& cell) const {
  if (!is_passable(cell)) return false;
  const UnknownAround around = unknown_around(cell);
  return around.cells >= kFrontierUnknownCells ||
         (around.cells >= kGapUnknownCells && is_in_large_unknown(around.one));
}

bool ExplorerMap::is_narrow(const Cell& cell) const {
  if (himm_.raw(cell) == 0) return false;
  bool is_clear = true;
  for_each_cell(square(cell, kNarrowCells),
                [&](const Cell& at) { is_clear = is_clear && !is_obstacle(at); });
  return is_clear;
}

bool ExplorerMap::is_between_obstacles(const Pose2& map_from_robot) const {
  const auto is_beside = [&](double sign) {
    for (double at_m = kCellM; at_m <= kBesideM; at_m += kCellM) {
      if (is_obstacle(frame().cell_of(map_from_robot * Point2(0.0, sign * at_m)))) return true;
    }
    return false;
  };
  return is_beside(1.0) && is_beside(-1.0);
}

bool ExplorerMap::borders_large_unknown(const Cell& cell) const {
  const UnknownAround around = unknown_around(cell);
  return around.cells >= kFrontierUnknownCells && is_in_large_unknown(around.one);
}

ExplorerMap::UnknownAround ExplorerMap::unknown_around(const Cell& cell) const {
  UnknownAround around{0, cell};
  for_each_cell(square(cell, kLookAroundCells), [&](const Cell& at) {
    if (himm_.raw(at) != 0) return;
    ++around.cells;
    around.one = at;
  });
  return around;
}

bool ExplorerMap::is_in_large_unknown(const Cell& cell) const {
  std::vector<Cell> found = {cell};
  std::unordered_set<std::int64_t> seen = {key_of(cell)};
  for (std::size_t i = 0; i < found.size() && found.size() < kLargeUnknownCells; ++i) {
    const Cell at = found[i];
    for (const Cell& next :
         {Cell{at.x + 1, at.y}, Cell{at.x - 1, at.y}, Cell{at.x, at.y + 1}, Cell{at.x, at.y - 1}}) {
      if (himm_.raw(next) == 0 && seen.insert(key_of(next)).second) found.push_back(next);
    }
  }
  return found.size() >= kLargeUnknownCells;
}

std::vector<Point2> ExplorerMap::obstacles_within(const Point2& center, double radius_m) const {
  const Cell low = frame().cell_of(center - Point2::Constant(radius_m));
  const Cell high = frame().cell_of(center + Point2::Constant(radius_m));
  std::vector<Point2> obstacles;
  for_each_cell({low, {high.x + 1, high.y + 1}}, [&](const Cell& cell) {
    const Point2 at = frame().center_of(cell);
    if (is_obstacle(cell) && (at - center).norm() <= radius_m) obstacles.push_back(at);
  });
  return obstacles;
}

}  // namespace roomatlas
