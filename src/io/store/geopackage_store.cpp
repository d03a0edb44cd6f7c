// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/store/geopackage_store.hpp"

#include "files/sync_file.hpp"
#include "geopackage_schema.hpp"
#include "geopackage_store_state.hpp"
#include "geopackage_tables.hpp"
#include "member_missions.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/results/judgement_json.hpp"
#include "roomatlas/io/results/summary.hpp"
#include "text/json.hpp"
#include "text/parse_json.hpp"

#include <charconv>

namespace roomatlas {
namespace {

namespace fs = std::filesystem;

fs::path beside(const fs::path& file, const char* ending) {
  fs::path path = file;
  return path += ending;
}

/// The schema's cookie tells a finished store. The tables never change, so no other program can
/// take this for another schema. VACUUM, the last thing done to a store, counts itself in it.
constexpr int kBeingWritten = 3;
constexpr int kBeforeVacuum = 1;
constexpr int kFinished = kBeforeVacuum + 1;

void set_cookie(Database& db, int cookie) {
  db.set_defensive(false);  // which forbids this
  db.execute("PRAGMA schema_version = " + std::to_string(cookie));
  db.set_defensive(true);
}

/// An empty file stays, with the permissions that it has.
void remove_old(const fs::path& file) {
  if (fs::is_directory(file)) {
    throw InputError(file.string() + ": is a directory, expected a file name for the store");
  }
  std::error_code error;
  const bool is_made = fs::is_regular_file(file, error) && fs::is_empty(file, error);
  error.clear();
  if (!is_made) fs::remove(file, error);
  if (error) throw InputError(file.string() + ": cannot be replaced: " + error.message());
  for (const char* ending : {"-wal", "-shm", "-journal"}) fs::remove(beside(file, ending), error);
}

std::unique_ptr<Database> create(const fs::path& file) {
  remove_old(file);
  auto database = std::make_unique<Database>(file, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  database->execute("PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL");
  SQLite::Transaction all_or_nothing(database->connection());
  create_schema(*database);
  all_or_nothing.commit();
  return database;
}

/// A run that was killed in the middle of a change leaves a journal, without which the store cannot
/// be read: the change is taken back, as SQLite does for anyone who may write.
void roll_back(const fs::path& file) {
  std::error_code missing;
  if (!fs::exists(beside(behind_links(file), "-journal"), missing)) return;
  try {
    Database(file, SQLite::OPEN_READWRITE).execute("SELECT count(*) FROM sqlite_master");
  } catch (const SQLite::Exception&) {  // who reads it says what is wrong with it
  }
}

std::unique_ptr<Database> open(const fs::path& file, bool writable) {
  if (!fs::is_regular_file(file)) {
    throw InputError(file.string() +
                     ": no such file, expected a building store: 'roomatlas map' writes one");
  }
  roll_back(file);
  auto database =
      std::make_unique<Database>(file, writable ? SQLite::OPEN_READWRITE : SQLite::OPEN_READONLY);
  check_schema(*database, file);
  if (writable) {
    database->execute("PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL");
    set_cookie(*database, kBeingWritten);
  }
  return database;
}

void stamp_date(Database& db) {
  std::optional<double> first_s;
  db.for_each_row("SELECT start_s FROM asr ORDER BY id LIMIT 1",
                  [&](Row& row) { first_s = row.real(); });
  db.run("UPDATE gpkg_contents SET last_change = ?", last_change_of(first_s));
}

/// Takes the database out of WAL mode, for which nobody else may have it open.
void leave_wal_mode(Database& db) {
  std::string mode;
  db.for_each_row("PRAGMA journal_mode = DELETE", [&](Row& row) { mode = row.text(); });
  if (mode != "delete") {
    throw SQLite::Exception("another program has the file open: close it and try again");
  }
}

/// Takes the database out of WAL mode and writes a fresh copy of its content.
void write_compact_copy(Database& db, const fs::path& copy) {
  db.forget_statements();
  db.execute("PRAGMA wal_checkpoint(TRUNCATE)");
  leave_wal_mode(db);
  set_cookie(db, kBeforeVacuum);
  db.run("VACUUM INTO ?", copy.string());
}

}  // namespace

std::string remedy(const SQLite::Exception& error) {
  constexpr int kError = 1;  // of SQL, which is ours: a table or column is not there
  constexpr int kBusy = 5;
  constexpr int kCorrupt = 11;
  constexpr int kFull = 13;
  switch (error.getErrorCode()) {
    case kError:
    case kCorrupt:
      return ": the store is damaged; map the log again, or take a copy of the store";
    case kBusy:
      return ": another program has it open; close that and try again";
    case kFull:
      return ": make room on the disk and run the same command again";
    default:
      return "";
  }
}

void write_metadata(Database& db, const std::map<std::string, std::string>& values) {
  for (const auto& [key, value] : values) {
    db.run(
        "INSERT INTO metadata (key, value) VALUES (?, ?) "
        "ON CONFLICT (key) DO UPDATE SET value = excluded.value",
        key, value);
  }
}

GeoPackageStore::GeoPackageStore(const fs::path& file, Mode mode)
    : state_(std::make_unique<State>()) {
  state_->file = file;
  state_->mode = mode;
  try {
    state_->database = mode == Mode::create ? create(file) : open(file, mode == Mode::update);
    state_->reads_matched_path =
        mode == Mode::read && state_->database->connection().tableExists("matched_path");
  } catch (const SQLite::Exception& error) {
    throw InputError(file.string() + ": cannot be opened: " + error.what());
  }
}

GeoPackageStore::~GeoPackageStore() {
  if (!state_->database || state_->is_read_only()) return;
  state_->database->forget_statements();
  // A WAL file on a network drive freezes QGIS; when this fails, the store is still whole.
  state_->database->connection().tryExec("PRAGMA journal_mode = DELETE");
}

void GeoPackageStore::put_metadata(const std::map<std::string, std::string>& values) {
  const auto version = values.find(kSchemaVersionKey);
  if (version != values.end() && version->second != std::to_string(kSchemaVersion)) {
    throw std::invalid_argument("the store writes its schema version itself");
  }
  state_->transaction([&](Database& db) { write_metadata(db, values); });
}

namespace {

/// Values whose keys say so are JSON objects; who reads them relies on that.
void require_json(const std::string& key, const std::string& value) {
  if (!key.ends_with("_json") || value.empty()) return;
  if (io::nests_too_deep(value) || !Json::parse(value, nullptr, false).is_object()) {
    throw DamagedData(key + " is no JSON object");
  }
  try {
    if (key == "judgement_json") (void)judgement_of(value);
    if (key == "answers_json") (void)answers_in({{key, value}});
  } catch (const InputError& error) {
    throw DamagedData(key + ": " + error.what());
  }
}

}  // namespace

std::optional<Judgement> GeoPackageStore::judgement() const {
  const std::map<std::string, std::string> values = metadata();
  const auto judgement = values.find("judgement_json");
  return judgement == values.end() ? std::nullopt : judgement_of(judgement->second);
}

Placement GeoPackageStore::other_answer() const { return other_answer_in(metadata()); }

std::map<std::string, std::string> GeoPackageStore::metadata() const {
  return state_->reading([](Database& db) {
    std::map<std::string, std::string> values;
    db.for_each_row("SELECT key, value FROM metadata", [&](Row& row) {
      std::string key = row.text();
      std::string value = row.text();
      require_json(key, value);
      values[std::move(key)] = std::move(value);
    });
    return values;
  });
}

std::vector<MemberMission> GeoPackageStore::members() const {
  return state_->reading([](Database& db) { return read_members(db); });
}

void GeoPackageStore::put_members(const std::vector<MemberMission>& members) {
  state_->transaction([&](Database& db) { write_members(db, members); });
}

const fs::path& GeoPackageStore::file() const { return state_->file; }

StoredMission GeoPackageStore::mission() const {
  const std::map<std::string, std::string> values = metadata();
  const auto number = [&](const char* key, double otherwise) {
    const auto entry = values.find(key);
    if (entry == values.end()) return otherwise;
    double value = otherwise;
    std::from_chars(entry->second.data(), entry->second.data() + entry->second.size(), value);
    return value;
  };
  StoredMission mission;
  if (const auto file = values.find("mission_file"); file != values.end()) {
    if (file->second.size() > kLongestName) {
      throw InputError(state_->file.string() +
                       ": table metadata, mission_file: is no file's name: it has " +
                       std::to_string(file->second.size()) + " bytes; map the log again");
    }
    mission.file = file->second;
  }
  RobotFootprint& robot = mission.footprint;
  robot = {number("robot_length_m", robot.length_m), number("robot_width_m", robot.width_m)};
  return mission;
}

void GeoPackageStore::finish() {
  state_->transaction([&](Database& db) {
    state_->write_pending_truth(db);
    stamp_date(db);
    forget_checkpoint(db);
  });
  state_->pending_truth.clear();
  const fs::path place = behind_links(state_->file);
  const fs::path copy = beside(place, ".tmp");
  state_->writing([&](Database& db) {
    create_like(copy, place);
    write_compact_copy(db, copy);
    state_->rows_of_closed_database = db.rows_fetched();
    state_->database.reset();
    sync_to_disk(copy);
    fs::rename(copy, place);
    sync_to_disk(fs::absolute(place).parent_path());
  });
}

bool GeoPackageStore::is_finished() const {
  const std::lock_guard lock(state_->mutex);
  if (!state_->database) return true;
  std::int64_t cookie = 0;
  state_->database->for_each_row("PRAGMA schema_version",
                                 [&](Row& row) { cookie = row.integer(); });
  return cookie == kFinished;
}

std::int64_t GeoPackageStore::rows_read() const {
  const std::lock_guard lock(state_->mutex);
  return state_->database ? state_->database->rows_fetched() : state_->rows_of_closed_database;
}

}  // namespace roomatlas
