// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// @file
/// All of the library that a program needs on the way from a log to a plan, stage by stage:
///
///     open_mission_to_map  a log           -> readings, one after another
///     map_mission          readings        -> ASRs, one for each visit to a room
///     assemble             ASRs            -> poses, rooms and doors: the floor plan
///     draw_plan            the floor plan  -> a drawing; `to_geojson` and others: data
///     evaluate             all of it       -> its errors, where the truth is known
///
/// Each stage takes values and gives values, so that one can begin or end anywhere on the way. The
/// headers of single steps are not here; each can be included by itself.

// Logs, and simulated robots that write some.
#include "roomatlas/io/logs/carmen_writer.hpp"
#include "roomatlas/io/logs/drive.hpp"
#include "roomatlas/io/logs/mission_writer.hpp"
#include "roomatlas/io/logs/open_mission.hpp"
#include "roomatlas/io/maps/read_world.hpp"
#include "roomatlas/simulate/explore.hpp"
#include "roomatlas/simulate/furnish.hpp"
#include "roomatlas/simulate/random_world.hpp"
#include "roomatlas/simulate/simulate.hpp"
#include "roomatlas/simulate/tour.hpp"

// Online stage; what it has found, in memory or in a file.
#include "roomatlas/asr/memory_store.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/pipeline/map_mission.hpp"

// Offline stage, and its solver for pose graphs of any other origin.
#include "roomatlas/correct/place.hpp"
#include "roomatlas/io/trajectories/pose_graph_file.hpp"
#include "roomatlas/pipeline/assemble.hpp"
#include "roomatlas/solve/optimize.hpp"

// The plan as a drawing and as data.
#include "roomatlas/draw/draw.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/maps/nav2_export.hpp"
#include "roomatlas/io/pictures/svg_pictures.hpp"
#include "roomatlas/io/plans/edits_file.hpp"
#include "roomatlas/io/plans/georeference.hpp"
#include "roomatlas/io/plans/ogr_export.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "roomatlas/io/plans/room_tables.hpp"

// Judging trajectories and plans.
#include "roomatlas/evaluate/evaluate.hpp"
#include "roomatlas/evaluate/evaluation.hpp"
#include "roomatlas/io/results/summary.hpp"
#include "roomatlas/io/trajectories/relations.hpp"
#include "roomatlas/io/trajectories/trajectory_file.hpp"
#include "roomatlas/io/trajectories/tum.hpp"

// Several missions of one building: joined, and where a robot was in it.
#include "roomatlas/pipeline/assemble_joined.hpp"
#include "roomatlas/pipeline/locate_mission.hpp"

// What changed between two missions in one building.
#include "roomatlas/changes/find_changes.hpp"
#include "roomatlas/changes/lay_on.hpp"
#include "roomatlas/draw/changes.hpp"
#include "roomatlas/io/plans/changes_files.hpp"
