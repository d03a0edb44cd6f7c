// SPDX-License-Identifier: GPL-3.0-or-later
// What an unfinished store has besides its rooms. Both tables are gone once it is finished.
#include "former_rooms.hpp"
#include "geopackage_schema.hpp"
#include "geopackage_store_state.hpp"

#include <zlib.h>

namespace roomatlas {
namespace {

constexpr const char* kCheckpoint = "checkpoint";
constexpr const char* kOrigin = "made_from";

Bytes bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

std::int64_t sum_of(ByteView bytes) {
  return static_cast<std::int64_t>(crc32_z(0, bytes.data(), bytes.size()));
}

void write_checkpoint(Database& db, AsrId last_asr, const std::string& checkpoint) {
  db.execute(
      "CREATE TABLE IF NOT EXISTS checkpoint (id INTEGER PRIMARY KEY, last_asr INTEGER NOT NULL, "
      "true_poses INTEGER NOT NULL, state BLOB NOT NULL, crc32 INTEGER NOT NULL)");
  const Bytes state = bytes_of(checkpoint);
  db.run(
      "INSERT OR REPLACE INTO checkpoint VALUES (1, ?, (SELECT coalesce(max(id), 0) FROM truth), "
      "?, ?)",
      last_asr, state, sum_of(state));
}

std::map<std::string, std::string> read_origin(Database& db) {
  std::map<std::string, std::string> origin;
  if (!db.connection().tableExists(kOrigin)) return origin;
  db.for_each_row("SELECT key, value FROM made_from", [&](Row& row) {
    std::string key = row.text();
    origin[std::move(key)] = row.text();
  });
  return origin;
}

}  // namespace

void forget_checkpoint(Database& db) {
  for (const char* table : {kCheckpoint, kOrigin}) {
    db.execute("DROP TABLE IF EXISTS " + std::string(table));
  }
}

void GeoPackageStore::put(const Asr& asr, const std::string& checkpoint) {
  state_->transaction([&](Database& db) {
    state_->replace_asr(db, asr);
    state_->write_pending_truth(db);
    write_checkpoint(db, asr.id, checkpoint);
  });
  state_->pending_truth.clear();
}

void GeoPackageStore::put_origin(const std::map<std::string, std::string>& origin) {
  state_->transaction([&](Database& db) {
    db.execute("DROP TABLE IF EXISTS made_from");
    db.execute("CREATE TABLE made_from (key TEXT PRIMARY KEY, value TEXT NOT NULL)");
    for (const auto& [key, value] : origin) {
      db.run("INSERT INTO made_from VALUES (?, ?)", key, value);
    }
  });
}

std::optional<GeoPackageStore::Unfinished> GeoPackageStore::unfinished() const {
  return state_->reading([](Database& db) {
    std::optional<Unfinished> unfinished;
    if (!db.connection().tableExists(kCheckpoint)) return unfinished;
    db.for_each_row("SELECT last_asr, state, crc32 FROM checkpoint WHERE id = 1", [&](Row& row) {
      unfinished.emplace().last_asr = row.integer();
      const ByteView state = row.blob();
      unfinished->checkpoint.assign(state.begin(), state.end());
      if (const std::int64_t sum = sum_of(state); row.integer() != sum) {
        throw DamagedData("found bytes whose sum is " + std::to_string(sum));
      }
    });
    if (unfinished) unfinished->origin = read_origin(db);
    return unfinished;
  });
}

void GeoPackageStore::go_back_to_checkpoint() {
  state_->transaction([](Database& db) {
    std::vector<AsrId> later;
    db.for_each_row("SELECT id FROM asr WHERE id > (SELECT last_asr FROM checkpoint)",
                    [&](Row& row) { later.push_back(row.integer()); });
    for (const AsrId asr : later) delete_asr(db, asr);
    db.run("DELETE FROM truth WHERE id > (SELECT true_poses FROM checkpoint)");
    db.run("DELETE FROM metadata WHERE key != ?", kSchemaVersionKey);
    write_former_rooms(db, {});
  });
}

}  // namespace roomatlas
