// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_building_robot.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas::random_building_layout {
namespace {

constexpr double kBesideDoorM = 0.1;  // the first sample behind a door, and the last before it
constexpr double kCellM = 0.1;        // of the grid that a room would have had
constexpr double kCellsOfWall = 3.0;  // raised across a wall: a hit raises its neighbours

Exit passage_at(PassageKind kind, const Pose2& frame_from_pivot, double width_m) {
  Exit exit;
  exit.kind = kind;
  exit.frame_from_pivot = frame_from_pivot;
  exit.width_m = width_m;
  const Point2 half(0.0, width_m / 2.0);
  exit.jambs = {frame_from_pivot * half, frame_from_pivot * Point2(-half)};
  return exit;
}

/// What a grid of the seen part would have held.
AsrCounters counters_of(const std::vector<WallPolyline>& walls, const Box2& seen) {
  AsrCounters counters;
  double walls_m = 0.0;
  for (const WallPolyline& wall : walls) {
    counters.vertices += static_cast<std::int64_t>(wall.vertices_asr.size());
    walls_m += length(wall.vertices_asr);
  }
  counters.grid_cells = static_cast<std::int64_t>(seen.size().prod() / (kCellM * kCellM));
  counters.grid_bytes = counters.grid_cells;
  counters.cleaned_cells = static_cast<std::int64_t>(walls_m / kCellM);
  counters.occupied_cells =
      static_cast<std::int64_t>(kCellsOfWall * static_cast<double>(counters.cleaned_cells));
  counters.extracted_points = counters.cleaned_cells;
  counters.geometry_bytes = counters.vertices * 2 * 4;
  return counters;
}

}  // namespace

RandomBuildingRobot::RandomBuildingRobot(const RandomBuildingOptions& options, AsrSink& sink,
                                         const std::function<void(const TrueVisit&)>& truth,
                                         const Space& start, const Pose2& world_from_start)
    : options_(options),
      sink_(sink),
      truth_(truth),
      odometer_(options.odometry, options.seed),
      vertex_noise_(options.seed, "vertex noise"),
      jamb_noise_(options.seed, "jamb noise"),
      space_(&start),
      world_from_robot_(world_from_start),
      time_s_(options.start_timestamp_s),
      odom_from_asr_(odometer_.odom_from_robot()),
      world_from_asr_(world_from_start) {
  sample();
}

Pose2 RandomBuildingRobot::asr_from_robot() const {
  return inverse(odom_from_asr_) * odometer_.odom_from_robot();
}

void RandomBuildingRobot::sample() {
  path_.push_back({time_s_, asr_from_robot(), odometer_.odom_from_robot()});
  world_from_path_.push_back(world_from_robot_);
  ++summary_.path_samples;
}

void RandomBuildingRobot::turn_to(double heading_rad) {
  const double turn_rad = wrap_angle(heading_rad - world_from_robot_.theta_rad);
  odometer_.add(0.0, turn_rad);
  world_from_robot_.theta_rad = wrap_angle(heading_rad);
}

void RandomBuildingRobot::advance(double length_m) {
  odometer_.add(length_m, 0.0);
  world_from_robot_ = world_from_robot_ * Pose2{length_m, 0.0, 0.0};
  time_s_ += length_m / options_.speed_m_per_s;
  visit_m_ += length_m;
  summary_.path_length_m += length_m;
}

void RandomBuildingRobot::forward(double length_m, bool may_cut) {
  const double pieces = std::max(1.0, std::ceil(length_m / options_.sample_every_m - 1e-9));
  for (double piece = 0.0; piece < pieces; piece += 1.0) {
    advance(length_m / pieces);
    if (may_cut && visit_m_ > options_.max_piece_path_m) {
      leave(passage_at(PassageKind::open_passage, asr_from_robot(), 0.0), *space_,
            world_from_robot_);
    }
    sample();
  }
}

void RandomBuildingRobot::go_to(const Point2& point) {
  const Point2 way = point - position();
  if (way.norm() < 1e-6) return;
  turn_to(std::atan2(way.y(), way.x()));
  forward(way.norm(), true);
}

/// The robot stands in the doorway, looking out: both jambs are measured from there.
Exit RandomBuildingRobot::seen_doorway(double width_m) {
  const auto seen = [&](double side) {
    const double x = options_.jamb_noise_m * jamb_noise_.normal();
    return Point2(x, side * width_m / 2.0 + options_.jamb_noise_m * jamb_noise_.normal());
  };
  const Point2 left = seen(1.0);
  const Point2 right = seen(-1.0);
  const Point2 middle = (left + right) / 2.0;
  const Point2 across = left - right;
  const Pose2 robot_from_pivot{middle.x(), middle.y(), std::atan2(-across.x(), across.y())};
  return passage_at(PassageKind::doorway, asr_from_robot() * robot_from_pivot, across.norm());
}

void RandomBuildingRobot::cross(const LaidOpening& opening, const Space& next) {
  const RoomId from = space_->id;
  const Point2 before = opening.world_from_pivot * Point2(-kBesideDoorM, 0.0);
  const Point2 way = before - position();
  if (way.norm() > 1e-6) {
    turn_to(std::atan2(way.y(), way.x()));
    forward(way.norm(), false);
  }
  turn_to(opening.world_from_pivot.theta_rad);
  advance(kBesideDoorM);
  ++summary_.crossings;
  const Exit exit = seen_doorway(opening.width_m);
  const bool was_entered_here = std::any_of(
      used_.begin(), used_.end(), [&](const auto& door) { return door.opening == &opening; });
  if (!was_entered_here) used_.push_back({&opening, exit});
  leave(exit, next, world_from_robot_ * (inverse(asr_from_robot()) * exit.frame_from_pivot));
  if (const LaidOpening* back = opening_to(next, from)) used_.push_back({back, *entry_});
  forward(kBesideDoorM, false);
}

/// The same passage as the space behind it sees it (see the recorder): the origin, looking back,
/// left and right exchanged.
void RandomBuildingRobot::leave(Exit exit, const Space& next, const Pose2& world_from_pivot) {
  const AsrId from = summary_.asrs + 1;
  exit.neighbor = from + 1;
  exit.timestamp_s = path_.back().timestamp_s;
  close(exit);
  odom_from_asr_ = odom_from_asr_ * exit.frame_from_pivot;
  world_from_asr_ = world_from_pivot;
  entry_ = exit;
  entry_->is_entry = true;
  entry_->neighbor = from;
  entry_->frame_from_pivot = {0.0, 0.0, wrap_angle(kPi)};
  const Pose2 entry_from_old = inverse(exit.frame_from_pivot);
  entry_->jambs = {entry_from_old * exit.jambs.b, entry_from_old * exit.jambs.a};
  space_ = &next;
}

void RandomBuildingRobot::close(const std::optional<Exit>& exit) {
  Asr asr;
  asr.id = ++summary_.asrs;
  asr.start_s = path_.front().timestamp_s;
  asr.end_s = path_.back().timestamp_s;
  asr.odom_from_asr = odom_from_asr_;
  if (entry_) asr.exits.push_back(*entry_);
  if (exit) asr.exits.push_back(*exit);

  Box2 path_box;
  for (const Pose2& world_from_robot : world_from_path_) {
    path_box.extend(world_from_robot.position());
  }
  const std::size_t middle = path_.size() / 2;
  const Pose2 asr_from_world = path_[middle].asr_from_robot * inverse(world_from_path_[middle]);
  const Box2 seen = seen_part(*space_, path_box);
  VisitShape shape =
      shape_of_visit(*space_, seen, used_, asr_from_world, options_.vertex_noise_m, vertex_noise_);
  asr.walls = std::move(shape.walls_asr);
  asr.outline_asr = std::move(shape.outline_asr);
  asr.reference_point_asr = asr_from_world * Point2((seen.min + seen.max) / 2.0);
  asr.counters = counters_of(asr.walls, seen);
  summary_.vertices += asr.counters.vertices;
  if (truth_) truth_({asr.id, space_->id, world_from_asr_});
  for (std::size_t i = 0; i < path_.size(); ++i) {
    sink_.put(TruePose{path_[i].timestamp_s, world_from_path_[i]});
  }
  asr.path = std::move(path_);
  sink_.put(asr);
  path_.clear();
  world_from_path_.clear();
  used_.clear();
  visit_m_ = 0.0;
}

void RandomBuildingRobot::finish() { close(std::nullopt); }

}  // namespace roomatlas::random_building_layout
