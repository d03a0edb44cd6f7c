// SPDX-License-Identifier: GPL-3.0-or-later
// Finished maps drawn from boxes in metres, at any angle and any size of cells.
#pragma once

#include <vector>

#include "roomatlas/rooms/partition_rooms.hpp"
#include "sketched_drive.hpp"

namespace roomatlas::test {

class SketchedMap {
 public:
  /// Floor that fills a box: a room, a doorway.
  SketchedMap& floor(double min_x, double min_y, double max_x, double max_y) {
    boxes_.push_back({{{min_x, min_y}, {max_x, max_y}}, Kind::floor});
    return *this;
  }
  /// An obstacle on the floor that was drawn before.
  SketchedMap& obstacle(double min_x, double min_y, double max_x, double max_y) {
    boxes_.push_back({{{min_x, min_y}, {max_x, max_y}}, Kind::obstacle});
    return *this;
  }
  /// What was not seen.
  SketchedMap& unseen(double min_x, double min_y, double max_x, double max_y) {
    boxes_.push_back({{{min_x, min_y}, {max_x, max_y}}, Kind::unseen});
    return *this;
  }
  /// The robot drives from point to point, a pose each 0.1 m.
  SketchedMap& drive(const std::vector<Point2>& points) {
    add_drive(points, path_);
    return *this;
  }

  /// Obstacles are all cells that are neither floor nor unseen.
  [[nodiscard]] PartitionEvidence evidence(double cell_m = 0.05, double turned_rad = 0.0) const {
    PartitionEvidence evidence;
    evidence.frame.cell_m = cell_m;
    const Pose2 map_from_sketch{0.0, 0.0, turned_rad};
    const Pose2 sketch_from_map = inverse(map_from_sketch);
    Box2 reach;
    for (const Drawn& drawn : boxes_) {
      for (const double x : {drawn.box.a.x() - 0.5, drawn.box.b.x() + 0.5}) {
        for (const double y : {drawn.box.a.y() - 0.5, drawn.box.b.y() + 0.5}) {
          reach.extend(map_from_sketch * Point2(x, y));
        }
      }
    }
    const CellBox box{evidence.frame.cell_of(reach.min), evidence.frame.cell_of(reach.max)};
    evidence.free = CellMask(box);
    evidence.obstacle = CellMask(box);
    for_each_cell(box, [&](const Cell& cell) {
      const Kind kind = kind_at(sketch_from_map * evidence.frame.center_of(cell));
      evidence.free.set(cell, kind == Kind::floor);
      evidence.obstacle.set(cell, kind == Kind::obstacle);
    });
    for (const Pose2& pose : path_) {
      evidence.building_from_robot.push_back(map_from_sketch * pose);
    }
    return evidence;
  }

 private:
  enum class Kind { floor, obstacle, unseen };
  struct Drawn {
    Segment2 box;
    Kind kind;
  };

  [[nodiscard]] Kind kind_at(const Point2& at) const {
    Kind kind = Kind::obstacle;
    for (const Drawn& drawn : boxes_) {
      if ((at.array() > drawn.box.a.array()).all() && (at.array() < drawn.box.b.array()).all()) {
        kind = drawn.kind;
      }
    }
    return kind;
  }

  std::vector<Drawn> boxes_;
  std::vector<Pose2> path_;
};

/// Two rooms of 4 m x 5 m, joined by a door of 0.9 m at (4.1, 2.45).
inline SketchedMap two_room_map() {
  return SketchedMap().floor(0, 0, 4, 5).floor(4.2, 0, 8.2, 5).floor(3.9, 2, 4.3, 2.9);
}

/// A corridor of 1.8 m x 24 m along y = 0 with six rooms on each side, all doors in line.
inline SketchedMap corridor_map() {
  SketchedMap map;
  map.floor(0.0, -0.9, 24.0, 0.9);
  for (int i = 0; i < 6; ++i) {
    const double x = 4.0 * i;
    map.floor(x, 1.1, x + 3.8, 6.0).floor(x + 0.4, 0.8, x + 1.4, 1.2);
    map.floor(x, -6.0, x + 3.8, -1.1).floor(x + 0.4, -1.2, x + 1.4, -0.8);
  }
  return map;
}

/// The room at a point of a sketch.
inline RoomId room_at(const RoomPartition& rooms, const PartitionEvidence& evidence,
                      const Point2& at, double turned_rad = 0.0) {
  return rooms.room_of_cell.get(evidence.frame.cell_of(Pose2{0.0, 0.0, turned_rad} * at));
}

}  // namespace roomatlas::test
