// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/store/room_names.hpp"

#include "database.hpp"
#include "geopackage_schema.hpp"
#include "roomatlas/core/issue.hpp"

namespace roomatlas {

void rename_room(const std::filesystem::path& store, RoomId id, const std::string& name) {
  try {
    Database db(store, SQLite::OPEN_READWRITE);
    check_schema(db, store);
    db.run("UPDATE rooms SET name = ? WHERE id = ?", name, id);
    if (db.connection().getChanges() == 0) {
      throw InputError(store.string() + ": has no room " + std::to_string(id));
    }
  } catch (const SQLite::Exception& error) {
    throw InputError(store.string() + ": " + error.what());
  }
}

}  // namespace roomatlas
