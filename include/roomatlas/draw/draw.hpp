// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/asr/map_room.hpp"
#include "roomatlas/core/geometry.hpp"
#include "roomatlas/plan/accuracy.hpp"
#include "roomatlas/plan/floor_plan.hpp"

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace roomatlas {

/// A place and how sure it is; building metres and axes.
struct UncertainPlace {
  Point2 at = Point2::Zero();
  Eigen::Matrix2d covariance_m2 = Eigen::Matrix2d::Zero();
};

/// Where one of several missions drove.
struct MissionPath {
  std::string name;
  Polyline path;  ///< building metres
};

/// What a plan drawing shows besides the plan itself. Everything is optional.
struct PlanAnnotations {
  std::string mission;  ///< for the title block, such as "fr079.clf.gz"
  std::string date;     ///< of the mission, never of the drawing
  double path_length_m = 0.0;
  Polyline trajectory;                ///< thin line; building metres
  std::vector<MissionPath> missions;  ///< instead, each in its colour and named in the legend
  std::vector<std::pair<RoomId, RoomId>> room_graph;  ///< drawn as a faint graph when not empty
  std::vector<Segment2> corrections;  ///< from where odometry had a visit to where it is
  std::vector<UncertainPlace> uncertainty;
  std::vector<Polyline> unexplored;  ///< where free space, to the left, ends without a wall; of a
                                     ///< plan that has edges, these say it instead
  std::optional<PlanAccuracy> accuracy;
  std::set<RoomId> doubtful_rooms;  ///< drawn paler
};

struct DrawOptions {
  bool show_trajectory = false;
  bool show_room_graph = false;
  bool show_corrections = false;
  bool show_uncertainty = false;
  std::optional<double> north_deg;  ///< where north is, clockwise from the building's y axis;
                                    ///< nothing: the axes of its coordinates are shown
};

/// The plan as an SVG document: millimetres on paper at a round scale, upright along the direction
/// of most walls (`main_direction_rad`). Layers are groups of class `layer` with stable ids: rooms,
/// furniture, walls, edges, unexplored, doors, trajectory, room-graph, corrections, uncertainty,
/// labels, door-widths, dimensions, notes, title. Those that are not to be shown are there with
/// `display="none"`. Text is real text. An empty plan gives a page that says so. Walls that nobody
/// measured (`FloorPlan::edges`) are never drawn solid.
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
