// SPDX-License-Identifier: GPL-3.0-or-later
#include "former_rooms.hpp"
#include "geopackage_store_state.hpp"
#include "geopackage_tables.hpp"
#include "stored_habits.hpp"
#include "stored_names.hpp"
#include "wkb.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace roomatlas {
namespace {

void require_metres(const std::vector<Point2>& points) {
  for (const Point2& point : points) {
    if (point.cwiseAbs().maxCoeff() <= Row::kLargest && point.allFinite()) continue;
    throw DamagedData("geometry has a coordinate that is no number of metres");
  }
}

void require_metres(const Polygon& polygon) {
  require_metres(polygon.outer);
  for (const Ring& hole : polygon.holes) require_metres(hole);
}

/// A polygon of a feature table.
Polygon drawn_polygon(Row& row) {
  Polygon polygon = polygon_of_wkb(wkb_of_geopackage_blob(row.blob()));
  require_metres(polygon);
  return polygon;
}

std::vector<AsrId> ids_of(const std::string& text) {
  std::vector<AsrId> ids;
  const char* const end = text.data() + text.size();
  for (const char* at = text.data(); at < end; ++at) {
    const std::from_chars_result number = std::from_chars(at, end, ids.emplace_back());
    if (number.ec != std::errc()) throw DamagedData("rooms.asrs has '" + text + "'");
    at = number.ptr;  // on the comma
  }
  return ids;
}

PlanRoom room_of(Row& row) {
  PlanRoom room;
  room.id = row.integer();
  room.parts = polygons_of_wkb(wkb_of_geopackage_blob(row.blob()));
  for (const Polygon& part : room.parts) require_metres(part);
  room.name = row.name();
  room.kind = value_of_stored_name(kRoomKinds, row.text());
  room.area_m2 = row.finite();
  room.label_point = row.point();
  room.asrs = ids_of(row.text());
  return room;
}

PlanDoor door_of(Row& row) {
  PlanDoor door;
  door.id = row.integer();
  door.opening = drawn_polygon(row).outer;
  door.width_m = row.finite();
  door.room_a = row.optional_integer();
  door.room_b = row.optional_integer();
  door.jambs.a = row.point();
  door.jambs.b = row.point();
  if (!row.has_more()) return door;  // made by an earlier release
  door.kind = value_of_stored_name(kDoorKinds, row.text());
  Segment2 leaf;
  for (double* at : {&leaf.a.x(), &leaf.a.y(), &leaf.b.x(), &leaf.b.y()}) *at = row.real();
  if (leaf.a.allFinite() && leaf.b.allFinite()) door.leaf = leaf;
  return door;
}

PlanFurniture furniture_of(Row& row) {
  (void)row.integer();  // id
  PlanFurniture piece;
  piece.outline = drawn_polygon(row);
  if (row.has_more()) piece.kind = value_of_stored_name(kFurnitureKinds, row.text());
  return piece;
}

PlanEdge edge_of(Row& row) {
  PlanEdge edge;
  const Polyline line = line_of_wkb(wkb_of_geopackage_blob(row.blob()));
  require_metres(line);
  if (line.size() != 2) throw DamagedData("an edge of a room has no two ends");
  edge.line = {line[0], line[1]};
  edge.room = row.integer();
  edge.evidence = value_of_stored_name(kWallEvidences, row.text());
  const double deviation_m = row.real();
  if (std::isfinite(deviation_m)) edge.deviation_m = deviation_m;
  return edge;
}

Issue issue_of(Row& row) {
  Issue issue;
  issue.severity = value_of_stored_name(kSeverities, row.text());
  issue.file = row.text();
  issue.line = row.integer();
  issue.field = row.text();
  issue.message = row.text();
  return issue;
}

AsrCorrection asr_correction_of(Row& row) {
  AsrCorrection asr;
  asr.asr = row.integer();
  asr.component = row.integer();
  asr.building_from_asr_before = row.pose();
  asr.building_from_asr = row.pose();
  asr.moved_m = row.real();
  asr.turned_rad = row.real();
  asr.chi_square_before = row.real();
  asr.chi_square_after = row.real();
  const std::string cause = row.text();
  if (!cause.empty()) asr.cause = value_of_stored_name(kFactorKinds, cause);
  asr.cause_asr = row.integer();
  return asr;
}

FactorReport factor_of(Row& row) {
  FactorReport factor;
  factor.kind = value_of_stored_name(kFactorKinds, row.text());
  factor.from = row.integer();
  factor.to = row.integer();
  factor.chi_square_before = row.real();
  factor.chi_square_after = row.real();
  factor.weight = row.real();
  return factor;
}

Closure closure_of(Row& row) {
  (void)row.integer();  // id
  Closure closure;
  closure.from = row.integer();
  closure.to = row.integer();
  if (closure.to == closure.from) {
    throw DamagedData("found the visit that it is from, expected another");
  }
  closure.match.first_from_second = row.pose();
  closure.match.agreeing = static_cast<int>(row.integer());
  closure.match.contradicting = static_cast<int>(row.integer());
  closure.match.unseen = static_cast<int>(row.integer());
  (void)row.integer();  // score
  closure.verdict = value_of_stored_name(kClosureVerdicts, row.text());
  closure.was_given = row.flag();
  if (!row.has_more()) return closure;  // made by an earlier release
  Eigen::Matrix3d& info = closure.match.information;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      info(i, j) = info(j, i) = row.real();
      if (i == j && info(i, i) < 0.0) throw DamagedData("found a negative information");
    }
  }
  if (!info.allFinite()) info.setZero();
  return closure;
}

/// The values of all rows of a query.
template <typename Value>
std::vector<Value> all(Database& db, const std::string& sql, Value (*value_of)(Row&)) {
  std::vector<Value> values;
  db.for_each_row(sql, [&](Row& row) { values.push_back(value_of(row)); });
  return values;
}

std::vector<Polygon> polygons_of(Database& db, const std::string& table) {
  return all<Polygon>(db, "SELECT geom FROM " + table + " ORDER BY id", drawn_polygon);
}

/// @param missing names, by their numbers, rows that another table speaks of
void require_rows(Database& db, const std::string& missing, const std::string& table,
                  const std::string& what) {
  db.for_each_row(missing + " LIMIT 1", [&](Row& row) {
    throw MissingRow("table " + table + " " + what + std::to_string(row.integer()));
  });
}

/// Every door and edge is of rooms that are there.
void require_rooms(Database& db, const std::string& prefix, bool has_edges) {
  db.for_each_row("SELECT id FROM " + prefix + "rooms WHERE id < 1", [](Row& row) {
    throw DamagedData("found " + std::to_string(row.integer()) + ", expected a number from 1");
  });
  const std::string rooms = " EXCEPT SELECT id FROM " + prefix + "rooms";
  const std::string doors = " FROM " + prefix + "doors WHERE room_";
  for (const char* side : {"a", "b"}) {
    require_rows(db, "SELECT room_" + std::string(side) + doors + side + " IS NOT NULL" + rooms,
                 prefix + "rooms", "has no row, and a door one, for room ");
  }
  if (!has_edges) return;
  require_rows(db, "SELECT room FROM " + prefix + "edges" + rooms, prefix + "rooms",
               "has no row, and an edge one, for room ");
}

/// Rooms, doors, walls, free space and edges.
/// @param prefix of the tables' names
FloorPlan shapes_of(Database& db, const std::string& prefix) {
  FloorPlan plan;
  plan.rooms = all(db, "SELECT * FROM " + prefix + "rooms ORDER BY id", room_of);
  plan.doors = all(db, "SELECT * FROM " + prefix + "doors ORDER BY id", door_of);
  plan.walls = polygons_of(db, prefix + "walls");
  plan.free_space = polygons_of(db, prefix + "free_space");
  const bool has_edges = db.connection().tableExists(prefix + "edges");
  require_rooms(db, prefix, has_edges);
  if (has_edges) {  // else made by an earlier release
    plan.edges =
        all(db, "SELECT geom, room, evidence, deviation_m FROM " + prefix + "edges ORDER BY id",
            edge_of);
  }
  return plan;
}

[[noreturn]] void throw_not_assembled(const std::filesystem::path& file) {
  throw InputError(file.string() + ": holds no floor plan yet: run 'roomatlas assemble " +
                   file.string() + "' first");
}

Correction summary_of(Row& row) {
  Correction correction;
  correction.converged = row.flag();
  correction.model = row.text();
  correction.message = row.text();
  correction.initial_cost = row.real();
  correction.final_cost = row.real();
  correction.iterations = static_cast<int>(row.integer());
  StoredHabits habits;
  habits.drift_rad_per_m = row.real();
  habits.turns_more_per_rad = row.real();
  correction.odometry = {habits_of(habits), static_cast<int>(row.integer())};
  return correction;
}

}  // namespace

bool GeoPackageStore::has_assembly() const {
  return state_->reading(
      [](Database& db) { return db.for_each_row("SELECT id FROM assembly", [](Row&) {}) > 0; });
}

Correction GeoPackageStore::correction() const {
  return state_->reading([&](Database& db) {
    const std::vector<Correction> summaries =
        all(db,
            "SELECT converged, model, message, initial_cost, final_cost, iterations, "
            "heading_bias_rad_per_m, heading_bias_rad_per_rad, heading_bias_asrs FROM assembly",
            summary_of);
    if (summaries.empty()) throw_not_assembled(state_->file);
    require_rows(db, "SELECT id FROM asr EXCEPT SELECT asr FROM corrections", "corrections",
                 "has no row for visit ");
    require_rows(db, "SELECT asr FROM corrections EXCEPT SELECT id FROM asr", "asr",
                 "has no row for the corrected visit ");
    require_rows(db,
                 "SELECT from_asr FROM factors UNION SELECT to_asr FROM factors WHERE to_asr <> 0 "
                 "EXCEPT SELECT id FROM asr",
                 "asr", "has no row, and `factors` one, for visit ");
    Correction correction = summaries.front();
    correction.asrs = all(db, "SELECT * FROM corrections ORDER BY asr", asr_correction_of);
    correction.factors =
        all(db,
            "SELECT kind, from_asr, to_asr, chi_square_before, chi_square_after, weight "
            "FROM factors ORDER BY id",
            factor_of);
    return correction;
  });
}

std::vector<Closure> GeoPackageStore::closures() const {
  return state_->reading([](Database& db) {
    require_rows(db,
                 "SELECT from_asr FROM closures UNION SELECT to_asr FROM closures "
                 "EXCEPT SELECT id FROM asr",
                 "asr", "has no row, and `closures` one, for visit ");
    return all(db, "SELECT * FROM closures ORDER BY id", closure_of);
  });
}

FloorPlan GeoPackageStore::plan() const {
  return state_->reading([&](Database& db) {
    FloorPlan plan = shapes_of(db, "");
    const std::int64_t found =
        db.for_each_row("SELECT title FROM assembly", [&](Row& row) { plan.title = row.name(); });
    if (found == 0) throw_not_assembled(state_->file);
    plan.furniture = all(db, "SELECT * FROM furniture ORDER BY id", furniture_of);
    plan.issues = all(db,
                      "SELECT severity, file, line, field, message FROM plan_issues "
                      "ORDER BY id",
                      issue_of);
    return plan;
  });
}

std::vector<PlanRoom> GeoPackageStore::former_rooms() const {
  // Not the whole plan: doors or walls that are damaged are made again from the visits.
  return state_->reading([](Database& db) {
    const std::vector<PlanRoom> rooms = read_former_rooms(db);
    return rooms.empty() ? all(db, "SELECT * FROM rooms ORDER BY id", room_of) : rooms;
  });
}

void GeoPackageStore::put_former_rooms(const std::vector<PlanRoom>& rooms) {
  state_->transaction([&](Database& db) { write_former_rooms(db, rooms); });
}

FloorPlan GeoPackageStore::measured_plan() const {
  FloorPlan plan = this->plan();
  FloorPlan measured = state_->reading([](Database& db) { return shapes_of(db, kMeasured); });
  if (measured.rooms.empty()) return plan;
  for (PlanRoom& room : measured.rooms) {
    const auto named = std::find_if(plan.rooms.begin(), plan.rooms.end(),
                                    [&](const PlanRoom& other) { return other.id == room.id; });
    if (named != plan.rooms.end()) room.name = named->name;
  }
  measured.title = std::move(plan.title);
  measured.furniture = std::move(plan.furniture);
  measured.issues = std::move(plan.issues);
  return measured;
}

}  // namespace roomatlas
