// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters.hpp"

#include <map>

#include "parameter_list.hpp"
#include "settings.hpp"

namespace roomatlas::apps {
namespace {

void add_mission(Parameters& all, MissionOptions& mission) {
  ParameterList stage(all, Stage::mission);
  stage.add("laser-max-range", mission.laser_max_range_m,
            "m; laser readings at or beyond it are no echo: free space", 0.5, 1000.0);
  stage.add("sonar-max-range", mission.sonar_max_range_m,
            "m; sonar readings at or beyond it are no echo: free space", 0.5, 100.0);
  stage.add("sonar-cone", mission.sonar_cone_deg, "deg; full opening angle of a sonar", 0.0, 90.0);
  AsSonarOptions& as_sonar = mission.as_sonar;
  stage.flag("as-sonar", as_sonar.enabled,
             "thin lasers to a ring of sonars: the least range in cones of 20 degrees");
  stage.add("as-sonar-noise", as_sonar.range_noise_m, "m; noise of the thinned ranges", 0.0, 1.0);
  stage.add("as-sonar-specular", as_sonar.specular_limit_deg,
            "deg; walls at a larger angle of incidence give the thinned ring no echo", 1.0, 90.0);
  stage.add("as-sonar-dropout", as_sonar.dropout_share, "share of thinned readings lost", 0.0, 1.0);
  stage.add("as-sonar-seed", as_sonar.seed, "of noise and losses of the thinned ring", 0.0,
            kLargestSeed);
  stage.add("robot-length", mission.footprint.length_m, "m; marks the robot's path", 0.05, 5.0);
  stage.add("robot-width", mission.footprint.width_m, "m; marks the robot's path", 0.05, 5.0);
}

/// What of a recording of topics is taken.
void add_recording(Parameters& all, RecordingOptions& recording) {
  ParameterList stage(all, Stage::mission);
  stage.text("scan-topic", recording.scan_topics,
             "of a bag: the laser's or cloud's topic; again for several. Empty: by their views");
  stage.text("odom-topic", recording.odometry_topic,
             "of a bag: odometry's topic, or tf, or none. Empty: by rate, coverage and motion");
  stage.text("imu-topic", recording.imu_topic,
             "of a bag: whose gyro tells turns, or none. Empty: one clearly better than odometry");
  stage.text("odom-frame", recording.odometry_frame, "of a bag: tf's frame of odometry");
  stage.text("base-frame", recording.base_frame, "of a bag: the robot's frame");
  stage.text("range-topics", recording.range_topics,
             "of a bag: single sonars that are one ring, separated by commas");
  stage.text("truth-topic", recording.truth_topic,
             "of a bag: the robot's true poses, or tf: those in its root frame (AMCL's), or none. "
             "Empty: the topic that is named for truth");
  stage.text("laser-mount", recording.laser_mount,
             "of a bag: x,y,deg (m, deg) of the laser on the robot, in the place of tf's");
  stage.add("cloud-low", recording.cloud_low_m, "m above the robot; a cloud's points from here ...",
            -100.0, 100.0);
  stage.add("cloud-high", recording.cloud_high_m, "m; ... to here are walls", -100.0, 100.0);
}

void add_map(Parameters& all, MapOptions& options) {
  ParameterList stage(all, Stage::rooms);
  stage.flag("find-reverse", options.directions.find_reverse,
             "find drives that odometry reports forwards and the readings show backwards");
  stage.flag("localize", options.localize.enabled,
             "match each laser sweep with the room so far; off: dead reckoning, as in the paper");
  stage.flag("find-kidnappings", options.kidnapping.enabled,
             "cut a laser's mission where the robot was carried away; off: it is one course");
  RecorderOptions& record = options.record;
  RoomMapOptions& map = record.map;
  stage.add(
      "cell", map.cell_m,
      "m; cell of the HIMM grid from which each room is mapped, and of no other grid. Smaller "
      "needs more readings a cell",
      0.02, 1.0);
  stage.add("max-mapped-range", map.max_mapped_range_m,
            "m; farther obstacles are not mapped. Larger smears walls by the drift in a room", 0.5,
            100.0);
  stage.add("sonar-no-echo", map.sonar_no_echo_m,
            "m; how much a sonar without echo frees. Larger tears open walls seen at a flat angle",
            0.0, 100.0);
  stage.add("laser-no-echo", map.laser_no_echo_m,
            "m; how much a laser without echo in range frees. Larger maps what glass lets through",
            0.0, 100.0);
  stage.add("epsilon", map.epsilon, "certainty above which a cell is occupied (paper: 7)", -2.0,
            14.5);
  stage.add("gamma", map.gamma_cells, "cells; largest gap inside a polyline (paper: 4)", 1.0, 50.0);
  stage.add("tau", map.tau_cells, "cells; points closer than this are dropped (paper: 2)", 0.0,
            20.0);
  stage.add("simplify-tolerance", map.simplify_tolerance_m,
            "m; Douglas-Peucker. Smaller keeps the steps of the raster", 0.0, 2.0);
  stage.add("sonar-simplify-tolerance", map.sonar_simplify_tolerance_m,
            "m; the same for walls seen by sonars", 0.0, 1.0);
  stage.choice("line-fit", map.fit.method, "how walls are fitted; regression is the paper's",
               std::map<std::string, FitMethod>{{"tls", FitMethod::total_least_squares},
                                                {"regression", FitMethod::regression}});
  stage.add("fit-sigma", map.fit.max_sigma_m,
            "m; largest residual of a fitted wall. Larger straightens curved walls", 0.0, 1.0);
  stage.add("fit-rho", map.fit.min_abs_rho, "smallest |rho| of a regression (paper: 0.9)", 0.0,
            1.0);
  stage.flag("refine-points", map.refine_points,
             "centre walls in their raised band of cells; off: cell centres, as in the paper");
  stage.add("min-hole", map.min_hole_m2, "m2; smaller holes in a room (furniture) are filled", 0.0,
            1000.0);
  stage.add("door-min-width", record.doorway.min_width_m,
            "m, before the jambs' raised cells are added; smaller takes furniture gaps for doors",
            0.2, 5.0);
  stage.add("door-max-width", record.doorway.max_width_m,
            "m; larger takes narrow corridors for doors", 0.2, 5.0);
  stage.add("door-widening", record.doorway.widening_m,
            "m; both sides of a door are this much wider. Smaller finds doors in corridors", 0.0,
            5.0);
  stage.add("door-lag", record.doorway_lag_m, "m; how far behind the robot doors are looked for",
            0.1, 5.0);
  stage.add("max-piece", record.max_piece_path_m,
            "m; longer visits are cut: odometry bends longer pieces", 1.0, 1000.0);
  stage.flag("keep-readings", record.keep_readings,
             "store each room's readings, so that it can be mapped again without the log");
}

void add_correction(Parameters& all, Settings& settings) {
  AssembleOptions& assemble = settings.assemble;
  ParameterList stage(all, Stage::correction);
  CorrectOptions& correct = assemble.correct;
  stage.flag(
      "correct-sonars", assemble.correct_sonars,
      "correct a mission with sonars as a whole, by its walls, before its rooms are mapped; one "
      "with a laser where its map would be doubtful");
  stage.add("without-closures", assemble.closures.without_best,
            "leave out this many of the best matches of rooms, to see what depends on them", 0,
            1e6);
  stage.file("add-closures", settings.add_closures,
             "file of matches to be tried: from_asr to_asr x_m y_m theta_rad a line");
  stage.flag("match-rooms", assemble.match_rooms,
             "find rooms again by their walls (laser); off: by their doorways alone");
  stage.flag("feed-back", assemble.feed_back.enabled,
             "match readings again with all rooms where these lie once corrected (laser)");
  stage.choice("model", correct.model,
               "se2, or rotation: the paper's, rooms turn about their entry pivots",
               std::map<std::string, CorrectionModel>{
                   {"se2", CorrectionModel::se2}, {"rotation", CorrectionModel::rotation_only}});
  stage.flag(
      "settle-on-walls", correct.settle_on_walls,
      "lay the building along its walls edge by edge, not along its rooms' common direction");
  stage.flag("wall-directions", correct.use_wall_directions,
             "rectilinear rooms follow the building's direction");
  stage.flag("heading-bias", correct.use_heading_bias,
             "estimate the drift of odometry's heading from the walls, and take it out");
  stage.add("odometry-position", correct.odometry.position.still, "m; sigma of a pivot", 1e-4,
            10.0);
  stage.add("odometry-position-rate", correct.odometry.position.per_m,
            "m per metre driven; sigma of a pivot", 0.0, 1.0);
  stage.degrees("odometry-heading", correct.odometry.heading.still, "deg; sigma between rooms",
                0.01, 90.0);
  stage.degrees("odometry-heading-rate", correct.odometry.heading.per_m,
                "deg per metre driven; sigma between rooms. Smaller resists the walls' direction",
                0.0, 45.0);
  stage.add("odometry-heading-turn", correct.odometry.heading.per_rad,
            "share of the turns made; sigma between rooms", 0.0, 1.0);
  stage.add("doorway-position", correct.doorway_position_m, "m; sigma of a doorway seen twice",
            1e-3, 10.0);
  stage.add("doorway-heading", correct.doorway_heading_deg, "deg; sigma of a doorway seen twice",
            0.01, 90.0);
  stage.add("wall-heading", correct.wall_heading_deg, "deg; sigma of a room's walls", 0.01, 45.0);
  stage.add("wall-heading-length", correct.wall_heading_deg_m,
            "deg m; over the length of the walls, added to it", 0.0, 1000.0);
  stage.add("wall-gate", correct.wall_gate_deg, "deg; walls farther off follow no common direction",
            0.0, 45.0);
  stage.add("passage-robust-sigmas", correct.passage_robust_sigmas,
            "where the robot was lost once, passages off by more sigmas lose weight", 0.1, 1000.0);
  stage.add("robust-sigmas", correct.robust_sigmas,
            "doorways and walls off by more sigmas lose weight", 0.1, 1000.0);
  stage.add("doorway-gate", assemble.recognise.gate_m,
            "m; doorways this near are the same, however short the path between", 0.0, 10.0);
  stage.add("doorway-gate-rate", assemble.recognise.gate_growth,
            "m per metre driven, added to the gate", 0.0, 1.0);
  stage.add("doorway-max-gate", assemble.recognise.max_gate_m, "m; the gate stops growing here",
            0.0, 20.0);
}

void add_plan(Parameters& all, Settings& settings) {
  ParameterList stage(all, Stage::plan);
  AssembleOptions& assemble = settings.assemble;
  stage.choice("plan", assemble.plan,
               "drafted: walls inferred as an architect draws them; traced: outlines of the ASRs",
               std::map<std::string, PlanStyle>{{"drafted", PlanStyle::drafted},
                                                {"traced", PlanStyle::traced}});
  stage.flag("draw-latest", assemble.draw_latest,
             "of several lasers' missions: what changed is drawn as the latest saw it; off: all "
             "together");
  DraftBuildingOptions& draft = assemble.draft;
  stage.add("occupied-share", draft.occupancy.occupied_share,
            "share of beams that a cell reflects from which it is an obstacle; higher loses glass",
            0.01, 1.0);
  stage.add("sonar-occupied-share", draft.sonar_rooms.grid.sonar_occupied_share,
            "the same where sonars' rooms are decided", 0.01, 1.0);
  stage.add("room-door-max-width", draft.sonar_rooms.doors.max_width_m,
            "m; widest door of sonars' rooms; larger takes corridors for doors", 0.3, 5.0);
  stage.add("min-room", draft.partition.min_driven_room_m2,
            "m2; smaller rooms join the one next door", 0.0, 100.0);
  stage.add("door-probability", draft.partition.min_door_probability,
            "openings less likely to be doors join rooms; larger joins more", 0.0, 1.0);
  stage.add("thickest-wall", draft.walls.thickest_m,
            "m; larger takes what stands between two faces for a wall", 0.1, 2.0);
  stage.add("widest-door", draft.doors.widest_door_m, "m; wider openings are passages", 0.3, 5.0);
  stage.add("room-overlap", assemble.rooms.min_overlap_share,
            "share of the smaller outline from which two visits are one room", 0.0, 1.0);
  stage.add("room-path", assemble.rooms.min_path_share,
            "share of a path inside another visit's outline from which both are one room", 0.0,
            1.0);
  stage.add("door-wall-share", assemble.rooms.min_wall_share,
            "share of wall beside a door's jambs, else it is no door but a gap", 0.0, 1.0);
  stage.flag("map-again", assemble.map_again,
             "cut rooms at the doors that only other visits found (needs the readings)");
  stage.flag("regular-walls", assemble.regular_walls,
             "draw walls along the building's directions, on common lines; the walls as measured "
             "stay in the store (`export --measured-walls`)");
  stage.add("regular-distance", assemble.regular.max_distance_m,
            "m; how far a regular wall may be from where it was seen", 0.0, 1.0);
  stage.add("sonar-blind-corner", assemble.sonar_corner_m,
            "m; longest cut-off corner that counts as not heard by sonars; 0 leaves them", 0.0,
            3.0);
  stage.add("wall-thickness", assemble.merge.wall_thickness_m,
            "m; of walls whose other side nobody saw", 0.02, 2.0);
  stage.flag("draw-path", settings.draw.show_trajectory, "draw the robot's path");
  stage.flag("draw-graph", settings.draw.show_room_graph, "draw the graph of rooms");
  stage.flag("draw-corrections", settings.draw.show_corrections,
             "draw an arrow for each visit that the correction moved");
  stage.flag("draw-uncertainty", settings.draw.show_uncertainty,
             "draw how sure each visit's place is");
  stage.add("label-pixel", settings.label_pixel_m, "m; pixel of label pictures given as truth",
            0.001, 10.0);
  stage.add("png-dpi", settings.png_dpi, "dots per inch of PNG pictures", 20.0, 1200.0);
}

void add_run(Parameters& all, Options& options) {
  ParameterList stage(all, Stage::run);
  stage.add("jobs", options.jobs, "threads that work at once; 0: one for each core", 0.0, 1024.0);
}

}  // namespace

const char* heading_of(Stage stage) {
  switch (stage) {
    case Stage::mission:
      return "Mission (what the log does not say)";
    case Stage::rooms:
      return "Rooms (online stage)";
    case Stage::correction:
      return "Correction (offline stage)";
    case Stage::plan:
      return "Floor plan";
    case Stage::simulation:
      return "Simulation";
    case Stage::run:
      return "Run (changes no result, and is kept nowhere)";
  }
  return "";
}

Parameters parameters_of(Settings& settings) {
  Parameters all;
  add_mission(all, settings.mission);
  add_recording(all, settings.mission.recording);
  add_map(all, settings.map);
  add_correction(all, settings);
  add_plan(all, settings);
  add_simulation(all, settings);
  add_run(all, settings);
  return all;
}

}  // namespace roomatlas::apps
