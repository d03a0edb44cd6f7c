// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/store/room_names.hpp"

#include "former_rooms.hpp"
#include "geopackage_schema.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "wkb.hpp"

namespace roomatlas {
namespace {

using Path = std::filesystem::path;

constexpr const char* kTable = "former_rooms";

/// Runs a call on the store's database, with the file's name on each error.
template <typename Call>
auto on_database(const Path& store, int mode, Call call) {
  try {
    Database database(store, mode);
    check_schema(database, store);
    return call(database);
  } catch (const SQLite::Exception& error) {
    throw InputError(store.string() + ": " + error.what());
  } catch (const DamagedData& error) {
    throw InputError(store.string() + ": " + error.what() + "; map the log again");
  }
}

PlanRoom room_of(Row& row) {
  PlanRoom room;
  room.id = row.integer();
  room.name = row.text();
  room.area_m2 = row.real();
  room.parts = polygons_of_wkb(row.blob());
  return room;
}

std::vector<PlanRoom> rooms_that_were_put(const Path& store) {
  return on_database(store, SQLite::OPEN_READONLY, [](Database& db) {
    std::vector<PlanRoom> rooms;
    if (!db.connection().tableExists(kTable)) return rooms;  // made by an earlier release
    db.for_each_row("SELECT id, name, area_m2, parts_wkb FROM former_rooms ORDER BY id",
                    [&](Row& row) { rooms.push_back(room_of(row)); });
    return rooms;
  });
}

}  // namespace

void create_former_rooms(Database& database) {
  database.execute(
      "CREATE TABLE former_rooms (id INTEGER PRIMARY KEY, name TEXT NOT NULL, area_m2 REAL, "
      "parts_wkb BLOB NOT NULL)");
  database.run(
      "INSERT INTO gpkg_contents (table_name, data_type, identifier, description, last_change) "
      "VALUES (?, 'attributes', ?, 'Rooms of the store that was replaced, until assembly', ?)",
      kTable, kTable, last_change_of(std::nullopt));
}

void rename_room(const Path& store, RoomId id, const std::string& name) {
  on_database(store, SQLite::OPEN_READWRITE, [&](Database& db) {
    db.run("UPDATE rooms SET name = ? WHERE id = ?", name, id);
    if (db.connection().getChanges() == 0) {
      throw InputError(store.string() + ": has no room " + std::to_string(id));
    }
  });
}

std::vector<PlanRoom> former_rooms(const Path& store) {
  {
    const GeoPackageStore reader(store, GeoPackageStore::Mode::read);
    if (reader.has_assembly()) return reader.plan().rooms;
  }
  return rooms_that_were_put(store);
}

void put_former_rooms(const Path& store, const std::vector<PlanRoom>& rooms) {
  on_database(store, SQLite::OPEN_READWRITE, [&](Database& db) {
    SQLite::Transaction all_or_nothing(db.connection());
    if (!db.connection().tableExists(kTable)) create_former_rooms(db);
    db.execute("DELETE FROM former_rooms");
    for (const PlanRoom& room : rooms) {
      db.run("INSERT INTO former_rooms VALUES (?, ?, ?, ?)", room.id, room.name, room.area_m2,
             wkb_of_polygons(room.parts));
    }
    all_or_nothing.commit();
  });
}

}  // namespace roomatlas
