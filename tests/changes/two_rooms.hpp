// SPDX-License-Identifier: GPL-3.0-or-later
// Two rooms with a door between them, as drawings, and missions through them whose poses are known
// and whose rays are cast by brute force.
#pragma once

#include <vector>

#include "roomatlas/asr/memory_store.hpp"
#include "roomatlas/changes/assembled_mission.hpp"
#include "support/drawn_world.hpp"

namespace roomatlas::test {

/// Rooms from (0.3, 0.3) to (4.8, 3.9) and from (5.1, 0.3) to (9.9, 3.9); the door between them
/// goes from (4.95, 1.5) to (4.95, 2.4).
inline WorldDrawing empty_rooms() {
  return {"##################################",  //
          "#               #                #", "#               #                #",
          "#               #                #", "#               #                #",
          "#               #                #", "#                                #",
          "#                                #", "#                                #",
          "#               #                #", "#               #                #",
          "#               #                #", "#               #                #",
          "##################################"};
}

/// With a block of letters filled, by its lowest letter; `fill` may empty it.
inline WorldDrawing with_block(WorldDrawing drawing, int column, int row, int columns, int rows,
                               char fill = '#') {
  for (int y = row; y < row + rows; ++y) {
    for (int x = column; x < column + columns; ++x) {
      drawing[drawing.size() - 1 - static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] = fill;
    }
  }
  return drawing;
}

inline Polygon block(int column, int row, int columns, int rows) {
  const Point2 low = kLetterM * Point2(column, row);
  const Point2 high = kLetterM * Point2(column + columns, row + rows);
  return {{low, {high.x(), low.y()}, high, {low.x(), high.y()}}, {}};
}

inline const Polyline kFirstRoom = {{0.9, 0.9}, {4.2, 0.9}, {4.2, 3.3}, {0.9, 3.3}};
inline const Polyline kSecondRoom = {{5.7, 3.3}, {9.3, 3.3}, {9.3, 0.9}, {5.7, 0.9}};

/// The plan of the empty rooms.
inline FloorPlan plan_of_rooms() {
  FloorPlan plan;
  plan.walls = plan_of(empty_rooms()).walls;
  const std::vector<Polygon> floors = {block(1, 1, 15, 12), block(17, 1, 16, 12)};
  for (const Polygon& floor : floors) {
    PlanRoom room;
    room.id = static_cast<RoomId>(plan.rooms.size() + 1);
    room.name = room.id == 1 ? "Office" : "Lab";
    room.parts = {floor};
    room.area_m2 = area(floor);
    room.label_point = interior_point(floor);
    plan.rooms.push_back(room);
  }
  PlanDoor door;
  door.id = 7;
  door.jambs = {{4.95, 1.5}, {4.95, 2.4}};
  door.width_m = 0.9;
  door.opening = block(16, 5, 1, 3).outer;
  door.room_a = 1;
  door.room_b = 2;
  plan.doors = {door};
  return plan;
}

/// One ASR for each path, all in the world's frame. Keeps what the mission points to.
struct KnownMission {
  MemoryStore store;
  AssembledMission mission;
};

inline void drive(KnownMission& known, const std::vector<Segment2>& surfaces,
                  const std::vector<Polyline>& paths, LaserRobot robot = {}) {
  robot.noise_m = 0.01;
  for (const Polyline& path : paths) {
    Asr asr;
    asr.id = static_cast<AsrId>(known.store.asrs.size() + 1);
    asr.readings = readings_along(surfaces, path, robot);
    for (const Pose2& pose : poses_along(path, robot)) {
      asr.path.push_back({asr.readings[asr.path.size()].timestamp_s, pose, pose});
    }
    robot.start_s = asr.readings.back().timestamp_s + 1.0;
    known.mission.placement[asr.id] = {};
    known.store.put(asr);
  }
  known.mission.source = &known.store;
}

/// @param furniture as the mission's plan has it
inline void drive(KnownMission& known, const WorldDrawing& drawing,
                  const std::vector<Polyline>& paths, const std::vector<Polygon>& furniture = {}) {
  drive(known, surfaces_of(drawing), paths);
  known.mission.plan = plan_of_rooms();
  for (const Polygon& piece : furniture) {
    known.mission.plan.furniture.push_back({piece, FurnitureKind::free_standing});
  }
}

}  // namespace roomatlas::test
