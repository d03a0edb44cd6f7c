// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/sqlite_defences.hpp"

#include <sqlite3.h>

#include <initializer_list>

namespace roomatlas::io {

void defend(sqlite3* connection, int largest_value_bytes) {
  for (const int setting : {SQLITE_DBCONFIG_TRUSTED_SCHEMA, SQLITE_DBCONFIG_ENABLE_TRIGGER,
                            SQLITE_DBCONFIG_ENABLE_VIEW, SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION}) {
    sqlite3_db_config(connection, setting, 0, nullptr);
  }
  sqlite3_limit(connection, SQLITE_LIMIT_ATTACHED, 1);  // VACUUM INTO needs one
  sqlite3_limit(connection, SQLITE_LIMIT_LENGTH, largest_value_bytes);
}

}  // namespace roomatlas::io
