// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

struct sqlite3;

namespace roomatlas::io {

/// A stranger's database may hold what was made to do harm: nothing in its schema (triggers, views,
/// extensions, functions with side effects) is executed on this connection, at most one other file
/// is attached, and no value is larger (sqlite.org/security.html).
void defend(sqlite3* connection, int largest_value_bytes);

}  // namespace roomatlas::io
