// SPDX-License-Identifier: GPL-3.0-or-later
#include "former_rooms.hpp"
#include "geopackage_schema.hpp"
#include "geopackage_store_state.hpp"
#include "geopackage_tables.hpp"
#include "roomatlas/io/results/judgement_json.hpp"
#include "roomatlas/io/results/summary.hpp"
#include "stored_habits.hpp"
#include "stored_names.hpp"
#include "wkb.hpp"

namespace roomatlas {
namespace {

/// One feature layer while it is written: gathers the layer's bounding box.
class Layer {
 public:
  Layer(Database& db, std::string table) : db_(db), table_(std::move(table)) {}
  Layer(const Layer&) = delete;
  Layer& operator=(const Layer&) = delete;

  [[nodiscard]] Bytes blob(const Polyline& line) { return boxed(wkb_of_line(line), bounds(line)); }
  [[nodiscard]] Bytes blob(const Polygon& polygon) {
    return boxed(wkb_of_polygon(polygon), bounds(polygon.outer));
  }
  [[nodiscard]] Bytes blob(const std::vector<Polygon>& polygons) {
    Box2 box;
    for (const Polygon& polygon : polygons) {
      for (const Point2& point : polygon.outer) box.extend(point);
    }
    return boxed(wkb_of_polygons(polygons), box);
  }

  void write_extent() {
    if (extent_.empty()) extent_.min = extent_.max = Point2::Constant(std::nan(""));  // NULL
    db_.run(
        "UPDATE gpkg_contents SET min_x = ?, min_y = ?, max_x = ?, max_y = ? "
        "WHERE table_name = ?",
        extent_.min, extent_.max, table_);
  }

 private:
  Bytes boxed(const Bytes& wkb, const Box2& box) {
    if (!box.empty()) {
      extent_.extend(box.min);
      extent_.extend(box.max);
    }
    return geopackage_blob(wkb, box, kBuildingSrsId);
  }

  Database& db_;
  std::string table_;
  Box2 extent_;
};

std::string joined(const std::vector<AsrId>& ids) {
  std::string text;
  for (const AsrId id : ids) text += (text.empty() ? "" : ",") + std::to_string(id);
  return text;
}

void write_rooms(Database& db, const std::string& table, const std::vector<PlanRoom>& rooms) {
  Layer layer(db, table);
  const std::string insert = "INSERT INTO " + table + " VALUES (?, ?, ?, ?, ?, ?, ?, ?)";
  for (const PlanRoom& room : rooms) {
    db.run(insert, room.id, layer.blob(room.parts), room.name, stored_name(kRoomKinds, room.kind),
           room.area_m2, room.label_point, joined(room.asrs));
  }
  layer.write_extent();
}

void write_doors(Database& db, const std::string& table, const std::vector<PlanDoor>& doors) {
  Layer layer(db, table);
  const std::string insert =
      "INSERT INTO " + table + " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)";
  const Point2 none = Point2::Constant(std::nan(""));  // NULL
  for (const PlanDoor& door : doors) {
    const Segment2 leaf = door.leaf.value_or(Segment2{none, none});
    db.run(insert, door.id, layer.blob(Polygon{door.opening, {}}), door.width_m, door.room_a,
           door.room_b, door.jambs.a, door.jambs.b, stored_name(kDoorKinds, door.kind), leaf.a,
           leaf.b);
  }
  layer.write_extent();
}

void write_polygons(Database& db, const std::string& table, const std::vector<Polygon>& polygons) {
  Layer layer(db, table);
  const std::string insert = "INSERT INTO " + table + " VALUES (NULL, ?)";
  for (const Polygon& polygon : polygons) db.run(insert, layer.blob(polygon));
  layer.write_extent();
}

void write_furniture(Database& db, const std::vector<PlanFurniture>& furniture) {
  Layer layer(db, "furniture");
  for (const PlanFurniture& piece : furniture) {
    db.run("INSERT INTO furniture VALUES (NULL, ?, ?)", layer.blob(piece.outline),
           stored_name(kFurnitureKinds, piece.kind));
  }
  layer.write_extent();
}

void write_edges(Database& db, const std::string& table, const std::vector<PlanEdge>& edges) {
  Layer layer(db, table);
  const std::string insert = "INSERT INTO " + table + " VALUES (NULL, ?, ?, ?, ?)";
  for (const PlanEdge& edge : edges) {
    db.run(insert, layer.blob(Polyline{edge.line.a, edge.line.b}), edge.room,
           stored_name(kWallEvidences, edge.evidence), edge.deviation_m.value_or(std::nan("")));
  }
  layer.write_extent();
}

void write_matched_path(Database& db, const Paths& paths) {
  for (const auto& [asr, path] : paths) {
    std::int64_t key = row_keys(asr).first;
    for (const Pose2& asr_from_robot : path) {
      db.run("INSERT INTO matched_path VALUES (?, ?, ?, ?)", key++, asr_from_robot);
    }
  }
}

void write_path(Database& db, const std::vector<AsrCorrection>& corrections) {
  Layer layer(db, "path");
  for (const AsrCorrection& correction : corrections) {
    const RowKeys keys = row_keys(correction.asr);
    Polyline line;
    db.for_each_row(
        "SELECT coalesce(matched_path.asr_from_robot_x_m, path_samples.asr_from_robot_x_m), "
        "coalesce(matched_path.asr_from_robot_y_m, path_samples.asr_from_robot_y_m) "
        "FROM path_samples LEFT JOIN matched_path USING (id) "
        "WHERE path_samples.id BETWEEN ? AND ? ORDER BY path_samples.id",
        [&](Row& row) { line.push_back(correction.building_from_asr * row.point()); }, keys.first,
        keys.last);
    if (line.size() < 2) continue;  // a point is no line
    db.run("INSERT INTO path VALUES (?, ?)", correction.asr, layer.blob(line));
  }
  layer.write_extent();
}

/// Rooms, doors, walls, free space and edges.
/// @param prefix of the tables' names
void write_shapes(Database& db, const std::string& prefix, const FloorPlan& plan) {
  write_rooms(db, prefix + "rooms", plan.rooms);
  write_doors(db, prefix + "doors", plan.doors);
  write_polygons(db, prefix + "walls", plan.walls);
  write_polygons(db, prefix + "free_space", plan.free_space);
  write_edges(db, prefix + "edges", plan.edges);
}

void write_plan(Database& db, const FloorPlan& plan) {
  write_shapes(db, "", plan);
  write_furniture(db, plan.furniture);
  for (const Issue& issue : plan.issues) {
    db.run("INSERT INTO plan_issues VALUES (NULL, ?, ?, ?, ?, ?)",
           stored_name(kSeverities, issue.severity), issue.file, issue.line, issue.field,
           issue.message);
  }
}

void write_correction(Database& db, const Correction& correction) {
  for (const AsrCorrection& asr : correction.asrs) {
    db.run("INSERT INTO corrections VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", asr.asr,
           asr.component, asr.building_from_asr_before, asr.building_from_asr, asr.moved_m,
           asr.turned_rad, asr.chi_square_before, asr.chi_square_after,
           asr.cause ? stored_name(kFactorKinds, *asr.cause) : "", asr.cause_asr);
  }
  for (const FactorReport& factor : correction.factors) {
    db.run("INSERT INTO factors VALUES (NULL, ?, ?, ?, ?, ?, ?)",
           stored_name(kFactorKinds, factor.kind), factor.from, factor.to, factor.chi_square_before,
           factor.chi_square_after, factor.weight);
  }
}

void write_closures(Database& db, const std::vector<Closure>& closures) {
  db.execute("DELETE FROM closures");
  for (const Closure& closure : closures) {
    const MapMatch& match = closure.match;
    const Eigen::Matrix3d& info = match.information;
    db.run("INSERT INTO closures VALUES (NULL, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
           closure.from, closure.to, match.first_from_second, match.agreeing, match.contradicting,
           match.unseen, closure.score(), stored_name(kClosureVerdicts, closure.verdict),
           closure.was_given, info(0, 0), info(0, 1), info(0, 2), info(1, 1), info(1, 2),
           info(2, 2));
  }
}

void write_results(Database& db, const Assembly& assembly) {
  const Correction& correction = assembly.correction;
  add_later_tables(db);
  for (const char* table : kResultTables) db.execute("DELETE FROM " + std::string(table));
  const StoredHabits habits = stored(correction.odometry.habits);
  db.run("INSERT INTO assembly VALUES (1, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", assembly.plan.title,
         correction.converged, correction.model, correction.message, correction.initial_cost,
         correction.final_cost, correction.iterations, habits.drift_rad_per_m,
         habits.turns_more_per_rad, correction.odometry.asrs);
  write_correction(db, correction);
  write_plan(db, assembly.plan);
  write_matched_path(db, assembly.paths);
  write_path(db, correction.asrs);
  db.run("UPDATE asr SET room = 0");
  for (const auto& [asr, room] : assembly.room_of_asr) {
    db.run("UPDATE asr SET room = ? WHERE id = ?", room, asr);
  }
}

std::map<std::string, std::string> metadata_of(const Assembly& assembly,
                                               const std::string& configuration) {
  std::map<std::string, std::string> values = {{"assembly_configuration", configuration}};
  if (!assembly.mapped_again.empty()) values["rooms_configuration"] = configuration;
  if (assembly.sonars) values["odometry_json"] = to_json(assembly.sonars->habits);
  values["judgement_json"] = assembly.judgement ? to_json(*assembly.judgement) : "";
  values["answers_json"] = assembly.answers.count > 1 ? to_json(assembly.answers) : "";
  values["other_answer_json"] = assembly.other_answer.empty() ? "" : to_json(assembly.other_answer);
  values["seen_last_json"] = assembly.seen_last.empty() ? "" : to_json(assembly.seen_last);
  return values;
}

/// The next assembly has them from the plan, but for those that the plan has not.
std::vector<PlanRoom> rooms_to_remember(const Assembly& assembly) {
  std::vector<PlanRoom> rooms = assembly.absent_rooms;
  if (rooms.empty()) return rooms;
  rooms.insert(rooms.end(), assembly.plan.rooms.begin(), assembly.plan.rooms.end());
  return rooms;
}

}  // namespace

void GeoPackageStore::put(const Assembly& assembly, const std::string& configuration) {
  state_->transaction([&](Database& db) {
    write_metadata(db, metadata_of(assembly, configuration));
    if (!assembly.mapped_again.empty()) state_->replace_asrs(db, assembly.mapped_again);
    write_results(db, assembly);
    if (assembly.measured_plan) write_shapes(db, kMeasured, *assembly.measured_plan);
    write_closures(db, assembly.closures);
    write_former_rooms(db, rooms_to_remember(assembly));
    forget_checkpoint(db);
  });
}

}  // namespace roomatlas
