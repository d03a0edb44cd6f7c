// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/store/room_names.hpp"

#include "database.hpp"
#include "geopackage_schema.hpp"
#include "roomatlas/core/issue.hpp"

namespace roomatlas {

void rename_room(const std::filesystem::path& store, RoomId id, const std::string& name,
                 const std::string& edits) {
  try {
    Database db(store, SQLite::OPEN_READWRITE);
    check_schema(db, store);
    SQLite::Transaction transaction(db.connection());
    db.run("UPDATE rooms SET name = ? WHERE id = ?", name, id);
    if (db.connection().getChanges() == 0) {
      throw InputError(store.string() + ": has no room " + std::to_string(id));
    }
    if (db.connection().tableExists("former_rooms")) {  // has all rooms, where one is absent
      db.run("UPDATE former_rooms SET name = ? WHERE id = ?", name, id);
    }
    db.run("DELETE FROM metadata WHERE key = 'edits_json'");
    if (!edits.empty()) db.run("INSERT INTO metadata (key, value) VALUES ('edits_json', ?)", edits);
    transaction.commit();
  } catch (const SQLite::Exception& error) {
    throw InputError(store.string() + ": " + error.what());
  }
}

}  // namespace roomatlas
