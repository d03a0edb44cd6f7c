// SPDX-License-Identifier: GPL-3.0-or-later
// Missions through rows of drawn rooms.
#pragma once

#include <vector>

#include "roomatlas/join/place_mission.hpp"
#include "support/drawn_shape.hpp"

namespace roomatlas::test {

/// Rooms in a row along x, and where they are.
struct Row {
  std::vector<DrawnWall> walls;
  std::vector<Point2> middles;
};

inline Row row_of(const std::vector<double>& widths, const std::vector<double>& boxes) {
  Row row;
  double x = 0.0;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    for (const DrawnWall& wall : room_walls(x, 0.0, widths[i], 4.0, boxes[i])) {
      row.walls.push_back(wall);
    }
    row.middles.push_back({x + widths[i] * 0.6, 2.6});
    x += widths[i] + 0.2;
  }
  return row;
}

inline Row building() { return row_of({4.0, 5.3, 7.1, 3.6, 6.2}, {0.8, 1.4, 1.1, 0.0, 1.9}); }
inline Row rooms_alike() { return row_of({5.0, 5.0, 5.0, 5.0, 5.0}, {1.0, 1.0, 1.0, 1.0, 1.0}); }

/// A mission through some rooms, in a frame of its own; each visit a frame of its own too.
inline MissionMap driven(const Row& row, const std::vector<std::size_t>& rooms, AsrId first,
                         const Pose2& mission_from_world) {
  MissionMap mission;
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    const Point2 middle = row.middles[rooms[i]];
    const Pose2 world_from_asr{middle.x(), middle.y(), 0.2 * static_cast<double>(i)};
    const AsrId id = first + static_cast<AsrId>(i);
    const std::vector<Point2> places = {middle + Point2{-0.8, -0.4}, middle,
                                        middle + Point2{0.5, 0.6}};
    mission.shapes.push_back(seen_shape(id, row.walls, places, inverse(world_from_asr)));
    mission.mission_from_asr[id] = mission_from_world * world_from_asr;
  }
  return mission;
}

}  // namespace roomatlas::test
