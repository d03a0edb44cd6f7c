// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/asr/map_room.hpp"
#include "roomatlas/core/geometry.hpp"
#include "roomatlas/merge/floor_plan.hpp"

#include <string>
#include <vector>

namespace roomatlas {

/// What a plan drawing shows besides the plan itself. Everything is optional.
struct PlanAnnotations {
  std::string mission;  ///< for the title block, such as "fr079.clf.gz"
  std::string date;     ///< of the mission, never of the drawing
  double path_length_m = 0.0;
  Polyline trajectory;                                ///< thin line; building metres
  std::vector<std::pair<RoomId, RoomId>> room_graph;  ///< drawn as a faint graph when not empty
};

struct DrawOptions {
  bool show_trajectory = false;
  bool show_room_graph = false;
};

/// The plan as an SVG document: millimetres on paper at a round scale. Layers are groups with
/// stable ids (rooms, walls, doors, trajectory, room-graph, labels, furniture, title). Text is
/// real text. An empty plan gives a page that says so.
[[nodiscard]] std::string draw_plan(const FloorPlan& plan, const PlanAnnotations& annotations,
                                    const DrawOptions& options);

/// The walls and the path as one placement of the ASRs draws them.
struct WallSketch {
  std::string caption;
  std::vector<Polyline> walls;  ///< building metres
  Polyline trajectory;
};

/// One room as the online stage makes it, step by step (paper Fig. 2, 3 and 7), six panels at one
/// scale with counts: the HIMM grid with the robot's path, the cleaned grid, the extracted points,
/// the points kept by Douglas and Peucker, the fitted lines, and those two over each other.
/// @param path the robot's positions in the ASR's frame
[[nodiscard]] std::string draw_room_steps(const RoomMap& map, const Polyline& path,
                                          const std::string& title);

/// Two sketches side by side at one scale: what raw odometry would have drawn, and the corrected
/// map.
[[nodiscard]] std::string draw_before_after(const WallSketch& before, const WallSketch& after);

}  // namespace roomatlas
