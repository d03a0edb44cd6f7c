// SPDX-License-Identifier: GPL-3.0-or-later
#include "former_rooms.hpp"

#include <optional>

#include "geopackage_schema.hpp"
#include "wkb.hpp"

namespace roomatlas {
namespace {

constexpr const char* kTable = "former_rooms";

PlanRoom former_room_of(Row& row) {
  PlanRoom room;
  room.id = row.integer();
  room.name = row.name();
  room.area_m2 = row.real();
  room.parts = polygons_of_wkb(row.blob());
  return room;
}

}  // namespace

void create_former_rooms(Database& db) {
  db.execute(
      "CREATE TABLE former_rooms (id INTEGER PRIMARY KEY, name TEXT NOT NULL, area_m2 REAL, "
      "parts_wkb BLOB NOT NULL)");
  db.run(
      "INSERT INTO gpkg_contents (table_name, data_type, identifier, description, last_change) "
      "VALUES (?, 'attributes', ?, 'Rooms whose numbers and names the next assembly carries over', "
      "?)",
      kTable, kTable, last_change_of(std::nullopt));
}

void write_former_rooms(Database& db, const std::vector<PlanRoom>& rooms) {
  if (!db.connection().tableExists(kTable)) create_former_rooms(db);
  db.execute("DELETE FROM former_rooms");
  for (const PlanRoom& room : rooms) {
    db.run("INSERT INTO former_rooms VALUES (?, ?, ?, ?)", room.id, room.name, room.area_m2,
           wkb_of_polygons(room.parts));
  }
}

std::vector<PlanRoom> read_former_rooms(Database& db) {
  std::vector<PlanRoom> rooms;
  if (!db.connection().tableExists(kTable)) return rooms;  // made by an earlier release
  db.for_each_row("SELECT id, name, area_m2, parts_wkb FROM former_rooms ORDER BY id",
                  [&](Row& row) { rooms.push_back(former_room_of(row)); });
  return rooms;
}

}  // namespace roomatlas
