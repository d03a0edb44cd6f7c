// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "sensor_table.hpp"

#include <filesystem>
#include <memory>
#include <mutex>

namespace roomatlas {

/// A row is missing that others speak of.
struct MissingRow : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What to do about what SQLite says, where that is known.
[[nodiscard]] std::string remedy(const SQLite::Exception& error);

struct GeoPackageStore::State {
  std::filesystem::path file;
  Mode mode = Mode::read;
  std::unique_ptr<Database> database;  ///< null once finished
  bool reads_matched_path = false;     ///< paths as they were matched again, where they were
  SensorTable sensors;
  std::vector<TruePose> pending_truth;  ///< waits for the next ASR's transaction
  std::int64_t rows_of_closed_database = 0;
  std::mutex mutex;

  [[nodiscard]] bool is_read_only() const {
    return mode == Mode::read || mode == Mode::read_as_mapped;
  }

  /// Runs one public call: alone, on an open store, with the file's name on each error.
  template <typename Call>
  auto reading(Call call) {
    const std::lock_guard lock(mutex);
    if (!database) throw std::logic_error("the store is finished");
    try {
      return call(*database);
    } catch (const SQLite::Exception& error) {
      throw InputError(file.string() + ": " + error.what() + remedy(error));
    } catch (const std::filesystem::filesystem_error& error) {
      throw InputError(file.string() + ": " + error.code().message());
    } catch (const MissingRow& error) {
      throw InputError(file.string() + ": " + error.what() +
                       ": the store is damaged; 'roomatlas assemble' makes these rows again, else "
                       "map the log again");
    } catch (const DamagedData& error) {
      throw InputError(file.string() + ": " + error.what() +
                       ": the store is damaged; map the log again");
    }
  }

  /// As `reading`, for calls that change the store.
  template <typename Call>
  auto writing(Call call) {
    if (is_read_only()) throw std::logic_error("the store is open for reading");
    return reading(call);
  }

  /// As `writing`, all or nothing.
  template <typename Call>
  void transaction(Call call) {
    writing([&](Database& db) {
      try {
        SQLite::Transaction all_or_nothing(db.connection(), SQLite::TransactionBehavior::IMMEDIATE);
        call(db);
        all_or_nothing.commit();
      } catch (...) {
        sensors.forget();  // it may know what was rolled back
        throw;
      }
    });
  }

  // Parts of a transaction:
  void write_pending_truth(Database& db);
  void write_asr(Database& db, const Asr& asr);
  /// Puts it in the place of the one with its number.
  void replace_asr(Database& db, const Asr& asr);
  /// Puts other ASRs in the place of all that are there.
  void replace_asrs(Database& db, const std::vector<Asr>& asrs);
};

/// Part of a transaction: removes an ASR, if it is there.
void delete_asr(Database& db, AsrId id);

/// Part of a transaction: keys that are there get new values.
void write_metadata(Database& db, const std::map<std::string, std::string>& values);

/// Part of a transaction: the store is no unfinished one any more.
void forget_checkpoint(Database& db);

/// The rows of one ASR in `exits` and `path_samples` have the keys first to last.
struct RowKeys {
  std::int64_t first = 0;
  std::int64_t last = 0;
};
[[nodiscard]] inline RowKeys row_keys(AsrId asr) { return {asr << 32, (asr << 32) | 0xffffffff}; }

}  // namespace roomatlas
