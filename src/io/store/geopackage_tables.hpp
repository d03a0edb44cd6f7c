// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

namespace roomatlas {

/// What gpkg_contents says of a table.
struct TableContents {
  const char* name;
  const char* geometry_type;  ///< null for a table of attributes
  const char* description;
};

inline constexpr std::array<TableContents, 24> kTables = {{
    {"rooms", "MULTIPOLYGON", "Rooms of the floor plan"},
    {"doors", "POLYGON", "Doorways: openings in the walls"},
    {"walls", "POLYGON", "Wall bodies with thickness"},
    {"free_space", "POLYGON", "Union of rooms and door openings"},
    {"edges", "LINESTRING", "Edges of the rooms, and what speaks for each"},
    {"furniture", "POLYGON", "Obstacles that are no walls"},
    {"measured_rooms", "MULTIPOLYGON", "Rooms before their walls were made regular"},
    {"measured_doors", "POLYGON", "Doorways in the walls as measured"},
    {"measured_walls", "POLYGON", "Wall bodies as measured"},
    {"measured_free_space", "POLYGON", "Free space as measured"},
    {"measured_edges", "LINESTRING", "Edges of the rooms as measured"},
    {"path", "LINESTRING", "Corrected path of the robot, one line a visit"},
    {"asr", nullptr, "Visits to spaces, each in its own frame"},
    {"exits", nullptr, "Passages through which the robot entered or left a visit"},
    {"path_samples", nullptr, "Poses of the robot, one a reading"},
    {"matched_path", nullptr, "Poses of the robot where readings were matched again"},
    {"sensors", nullptr, "Range sensors and their beams"},
    {"readings", nullptr, "Range readings, compressed, one row a visit"},
    {"truth", nullptr, "True poses in the order of the log"},
    {"assembly", nullptr, "Title of the plan and summary of the correction"},
    {"corrections", nullptr, "Poses of the visits in the building, before and after"},
    {"factors", nullptr, "Measurements between visits and what became of them"},
    {"plan_issues", nullptr, "What was imperfect in the plan"},
    {"metadata", nullptr, "About the run: versions, configuration, input"},
}};

/// The tables that an assembly fills and the next one replaces.
inline constexpr std::array<const char*, 18> kResultTables = {
    "rooms",          "doors",          "walls",          "free_space",          "edges",
    "measured_rooms", "measured_doors", "measured_walls", "measured_free_space", "measured_edges",
    "furniture",      "path",           "assembly",       "corrections",         "factors",
    "plan_issues",    "closures",       "matched_path"};

/// Before the names of the tables that hold the plan as measured.
inline constexpr const char* kMeasured = "measured_";

extern const char* const kGeoPackageSql;   ///< the tables that the standard asks for
extern const char* const kMissionSql;      ///< what the online stage writes
extern const char* const kResultSql;       ///< what the offline stage writes
extern const char* const kMatchedPathSql;  ///< the same, where the store does not have it yet

/// The tables of a plan's shapes, but for its edges. @param prefix of their names: none, or
/// kMeasured
[[nodiscard]] std::string shapes_sql(const std::string& prefix);
/// The table of its edges.
[[nodiscard]] std::string edges_sql(const std::string& prefix);

}  // namespace roomatlas
