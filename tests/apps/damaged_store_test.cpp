// SPDX-License-Identifier: GPL-3.0-or-later
// Stores that were damaged, through SQL and byte by byte. ROOMATLAS_MUTATIONS=N tries N of them
// instead of a few, ROOMATLAS_MUTATION_SEED=S others.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>

#include <array>
#include <random>

#include "random_store.hpp"

namespace roomatlas::test {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

std::uint64_t count_of_mutations() {
  const char* wanted = std::getenv("ROOMATLAS_MUTATIONS");
  return wanted != nullptr ? std::stoull(wanted) : 25;
}

std::uint64_t first_seed() {
  const char* wanted = std::getenv("ROOMATLAS_MUTATION_SEED");
  return wanted != nullptr ? 1'000'000 * std::stoull(wanted) : 0;
}

/// Damages a store; the same number does the same.
class Damage {
 public:
  explicit Damage(std::uint64_t seed) : random_(seed) {}

  /// @returns what was done
  std::string operator()(const fs::path& store) {
    return below(4) == 0 ? flip_or_cut(store) : through_sql(store);
  }

 private:
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }

  std::string flip_or_cut(const fs::path& store) {
    std::string bytes = content_of(store);
    if (below(4) == 0) {
      bytes.resize(below(bytes.size()));
    } else {
      for (std::size_t flips = 1 + below(20); flips > 0; --flips) {
        bytes[below(bytes.size())] ^= static_cast<char>(1U << below(8));
      }
    }
    std::ofstream(store, std::ios::binary) << bytes;
    return "bytes";
  }

  static std::vector<std::string> texts(SQLite::Database& db, const std::string& sql) {
    std::vector<std::string> all;
    SQLite::Statement statement(db, sql);
    while (statement.executeStep()) all.push_back(statement.getColumn(0).getString());
    return all;
  }

  std::string through_sql(const fs::path& store) {
    SQLite::Database db(store.string(), SQLite::OPEN_READWRITE);
    const auto tables = texts(db,
                              "SELECT name FROM sqlite_master WHERE type = 'table' AND name NOT "
                              "LIKE 'sqlite%' AND name NOT LIKE 'gpkg%' ORDER BY name");
    const std::string table = tables[below(tables.size())];
    if (below(6) == 0) return executed(db, "DROP TABLE " + table);
    const auto rows = texts(db, "SELECT rowid FROM " + table);
    if (rows.empty()) return "nothing";
    const std::string where = " WHERE rowid = " + rows[below(rows.size())];
    if (below(5) == 0) return executed(db, "DELETE FROM " + table + where);
    if (below(5) == 0) return executed(db, "DELETE FROM " + table + " WHERE rowid % 2 = 0");
    const auto columns = texts(db, "SELECT name FROM pragma_table_info('" + table + "')");
    const std::string column = columns[below(columns.size())];
    constexpr std::array kValues = {"'words'", "x'ff00'", "-1",   "0",   "1000000000000",
                                    "1e300",   "9e999",   "NULL", "3.7", "''"};
    const std::string half = "substr(" + column + ", 1, length(" + column + ") / 2)";
    const std::string value = below(3) == 0 ? half : kValues[below(kValues.size())];
    return executed(db, "UPDATE " + table + " SET " + column + " = " + value + where);
  }

  static std::string executed(SQLite::Database& db, const std::string& sql) {
    return db.tryExec(sql) == 0 ? sql : "refused: " + sql;  // by what the schema demands
  }

  std::mt19937_64 random_;
};

class DamagedStore : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new Folder;
    whole_ = assembled_store(*folder_);
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }
  [[nodiscard]] static std::string copy(const std::string& sql = "") {
    const std::string store = (*folder_ / "damaged.gpkg").string();
    fs::copy_file(whole_, store, fs::copy_options::overwrite_existing);
    if (!sql.empty()) SQLite::Database(store, SQLite::OPEN_READWRITE).exec(sql);
    return store;
  }
  [[nodiscard]] static std::string out() { return (*folder_ / "out").string(); }

  static inline Folder* folder_ = nullptr;
  static inline std::string whole_;
};

TEST_F(DamagedStore, NeverEndsACommandWithAnInternalError) {
  for (std::uint64_t seed = 1; seed <= count_of_mutations(); ++seed) {
    const std::string store = copy();
    const std::string done = Damage(first_seed() + seed)(store);
    const std::array commands = {
        "export " + store + " -f geojson,tum,g2o,nav2,json,csv,graphml,dot -o " + out(),
        "export " + store + " -f svg -o " + out(),
        "evaluate " + store,
        "rename " + store + " 1 Kitchen" + std::to_string(seed),
        "report " + store + " -o " + (*folder_ / "page.html").string(),
        "assemble " + store,
        "join " + store + " " + whole_ + " -o " + (*folder_ / "joined.gpkg").string()};
    const std::string& command = commands[seed % commands.size()];
    const Outcome outcome = run("-q " + command);
    EXPECT_THAT(outcome.exit_code, AnyOf(0, 2, 3, 4)) << done << "\n" << command << outcome.err;
    EXPECT_THAT(outcome.err, ::testing::Not(HasSubstr("map::at"))) << done;
  }
}

TEST_F(DamagedStore, WhatIsExportedCanBeRead) {
  for (std::uint64_t seed = 1001; seed <= 1000 + count_of_mutations() / 2; ++seed) {
    const std::string store = copy();
    const std::string done = Damage(first_seed() + seed)(store);
    if (run("-q export " + store + " -f geojson,g2o -o " + out()).exit_code != 0) continue;
    const std::string plan = (fs::path(out()) / "plan.local.geojson").string();
    const Outcome judged = run("-q evaluate " + whole_ + " --truth " + plan);
    EXPECT_THAT(judged.exit_code, AnyOf(0, 4)) << done << "\n" << judged.err;
    const Outcome solved = run("-q optimize " + out() + "/graph.g2o -o " + out() + "/solved.g2o");
    EXPECT_THAT(solved.exit_code, AnyOf(0, 4)) << done << "\n" << solved.err;
  }
}

TEST_F(DamagedStore, MetadataThatIsNotWhatItsKeySaysIsRefusedByItsKey) {
  const std::string deep = std::string(2000, '[') + std::string(2000, ']');
  for (const std::string key : {"mission_json", "odometry_json", "judgement_json", "answers_json",
                                "other_answer_json", "seen_last_json", "edits_json"}) {
    for (const std::string& value : {std::string("{"), std::string("[]"), std::string("17"), deep,
                                     std::string(R"({"count":"x","edits":5,"signals":[[]]})")}) {
      const std::string store = copy("INSERT OR REPLACE INTO metadata (key, value) VALUES ('" +
                                     key + "', '" + value + "')");
      for (const std::string& command :
           {"export " + store + " -f json,geojson -o " + out(), "assemble " + store,
            "report " + store + " -o " + (*folder_ / "page.html").string()}) {
        const Outcome outcome = run("-q " + command);
        EXPECT_THAT(outcome.exit_code, AnyOf(0, 3)) << key << value << command << outcome.err;
        if (outcome.exit_code != 0) {
          EXPECT_THAT(outcome.err, HasSubstr(key)) << value << command;
        }
      }
    }
  }
}

TEST_F(DamagedStore, SaysTableRowFieldAndWhatIsExpected) {
  const auto error_of = [&](const std::string& sql) {
    const Outcome outcome = run("-q export " + copy(sql) + " -f geojson -o " + out());
    EXPECT_EQ(outcome.exit_code, 3) << sql << outcome.err;
    return outcome.err;
  };
  EXPECT_THAT(error_of("UPDATE rooms SET area_m2 = 'large' WHERE id = 3"),
              AllOf(HasSubstr("damaged.gpkg: table rooms, row 3, field area_m2: found text, "
                              "expected a number"),
                    HasSubstr("map the log again")));
  EXPECT_THAT(error_of("UPDATE rooms SET geom = substr(geom, 1, 60) WHERE id = 2"),
              HasSubstr("table rooms, row 2, field geom: the data ends early"));
  EXPECT_THAT(error_of("UPDATE rooms SET name = hex(zeroblob(500000)) WHERE id = 3"),
              HasSubstr("field name: found a name of 1000000 bytes, expected at most 1000"));
  const Outcome edits =
      run("-q assemble " + copy("INSERT INTO metadata (key, value) VALUES ('edits_json', '{}')"));
  EXPECT_EQ(edits.exit_code, 3);
  EXPECT_THAT(edits.err, HasSubstr("damaged.gpkg: metadata edits_json: "));
  EXPECT_THAT(error_of("UPDATE exits SET neighbor = asr"), HasSubstr("neighbor is the exit's own"));
  EXPECT_THAT(error_of("DELETE FROM corrections WHERE asr = 4"),
              AllOf(HasSubstr("table corrections has no row for visit 4"),
                    HasSubstr("'roomatlas assemble' makes these rows again")));
  EXPECT_THAT(error_of("DROP TABLE corrections"),
              AllOf(HasSubstr("no such table: corrections"), HasSubstr("the store is damaged")));
}

TEST_F(DamagedStore, IsMadeAgainByAssembleWhereItSaysSo) {
  for (const char* sql : {"UPDATE doors SET room_b = 999 WHERE id = 1", "DELETE FROM rooms",
                          "DELETE FROM edges", "DELETE FROM corrections WHERE asr = 4"}) {
    const std::string store = copy(sql);
    const Outcome broken = run("-q export " + store + " -f geojson -o " + out());
    if (broken.exit_code != 0) {
      EXPECT_THAT(broken.err, HasSubstr("'roomatlas assemble' makes these rows again")) << sql;
    }
    const Outcome again = run("-q assemble " + store);
    EXPECT_EQ(again.exit_code, 0) << sql << again.err;
    EXPECT_EQ(run("-q export " + store + " -f geojson -o " + out()).exit_code, 0) << sql;
  }
}

TEST_F(DamagedStore, NothingInAStrangersSchemaIsExecuted) {
  const std::string store =
      copy("CREATE TRIGGER harm AFTER UPDATE ON rooms BEGIN UPDATE rooms SET name = 'harmed'; END");
  ASSERT_EQ(run("-q rename " + store + " 3 Kitchen").exit_code, 0);
  SQLite::Database db(store);
  EXPECT_EQ(db.execAndGet("SELECT count(*) FROM rooms WHERE name = 'harmed'").getInt(), 0);
  EXPECT_EQ(db.execAndGet("SELECT name FROM rooms WHERE id = 3").getString(), "Kitchen");

  const Outcome outcome =
      run("-q export " +
          copy("ALTER TABLE walls RENAME TO own; CREATE VIEW walls AS SELECT * FROM own") +
          " -f csv -o " + out());
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("access to view"));
}

}  // namespace
}  // namespace roomatlas::test
