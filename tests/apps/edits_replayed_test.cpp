// SPDX-License-Identifier: GPL-3.0-or-later
// All kinds of statements together, replayed after mapping again and with another mission joined.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "edited_store.hpp"

namespace roomatlas::test {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

/// One of each kind; `open_door` takes back a `shut_door` before it.
constexpr const char* kAllKinds = R"(
  {"edit":"name_room","room":{"id":9},"name":"Kitchen"},
  {"edit":"set_room_kind","room":{"id":6},"kind":"hall"},
  {"edit":"join_rooms","rooms":[{"id":2},{"id":4}]},
  {"edit":"split_room","room":{"id":3},"line_m":[[11.0,-0.7],[11.0,4.1]]},
  {"edit":"shut_door","at_m":[2.6,0.3]},
  {"edit":"shut_door","at_m":[6.7,11.0]},
  {"edit":"open_door","at_m":[6.7,11.0]},
  {"edit":"add_door","jambs_m":[[-0.5,6.8],[0.4,6.8]]},
  {"edit":"move_wall","wall_m":[[16.0,4.0],[21.0,4.0]],"by_m":0.3},
  {"edit":"furniture_to_wall","at_m":[18.5,8.6]},
  {"edit":"wall_to_furniture","at_m":[8.8,9.0],
   "outline_m":[[8.7,8.5],[8.9,8.5],[8.9,9.5],[8.7,9.5]]},
  {"edit":"reject_closure","from_time_s":1000000456.8,"to_time_s":1000000659.8},
  {"edit":"pin_visits","from_time_s":1000000007.3,"to_time_s":1000000016.9,
   "from_from_to":{"x_m":2.45,"y_m":0.31,"theta_rad":0.097}})";

/// A laser's missions through the eight rooms: one through all, mapped and assembled, and a short
/// one through some.
class EditsReplayed : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    shared_ = new Folder;
    const std::string world =
        std::string(ROOMATLAS_SOURCE_DIR) + "/data/worlds/eight_rooms.geojson";
    const std::string simulate = "-q simulate " + world + " --sensor laser -o ";
    ASSERT_EQ(run(simulate + (*shared_ / "m").string()).exit_code, 0);
    ASSERT_EQ(run(simulate + (*shared_ / "other").string() + " --max-time 250 --seed 5").exit_code,
              0);
    mapped("m", "b.gpkg");
    mapped("other", "other.gpkg");
  }
  static void TearDownTestSuite() { delete shared_; }
  void SetUp() override { std::filesystem::copy_file(*shared_ / "b.gpkg", store()); }

  static std::string log(const std::string& mission) {
    return (*shared_ / (mission + "/mission.clf")).string();
  }
  static void mapped(const std::string& mission, const std::string& store) {
    ASSERT_EQ(run("-q map " + log(mission) + " -o " + (*shared_ / store).string()).exit_code, 0);
    std::filesystem::copy_file(*shared_ / store, *shared_ / ("mapped_" + store));
    ASSERT_EQ(run("-q assemble " + (*shared_ / store).string()).exit_code, 0);
  }
  [[nodiscard]] std::string store() const { return (folder_ / "building.gpkg").string(); }
  [[nodiscard]] std::string plan_of(const std::string& store) const {
    const std::string out = (folder_ / "plan").string();
    EXPECT_EQ(run("-q export " + store + " -f geojson -o " + out).exit_code, 0);
    return content_of(out + "/plan.local.geojson");
  }
  /// The first column of the first row.
  static std::string told(const std::string& store, const std::string& query) {
    SQLite::Database db(store);
    SQLite::Statement rows(db, query);
    return rows.executeStep() ? rows.getColumn(0).getString() : "";
  }
  /// What the statements say of rooms, doors and walls.
  /// @param by_m of the wall between rooms 5 and 6
  static void expect_all_kinds(const std::string& store, double by_m) {
    EXPECT_EQ(told(store, "SELECT kind FROM rooms WHERE id = 6"), "hall");
    EXPECT_EQ(told(store, "SELECT count(*) FROM rooms"), "10") << "one joined, one split";
    EXPECT_EQ(told(store, "SELECT count(*) FROM rooms WHERE id = 4"), "0");
    EXPECT_EQ(told(store, "SELECT count(*) FROM doors WHERE room_a = 1 OR room_b = 1"), "0");
    EXPECT_EQ(told(store, "SELECT count(*) FROM doors WHERE room_a = 2 AND room_b = 8"), "1");
    EXPECT_EQ(told(store, "SELECT count(*) FROM doors WHERE room_a = 9 AND room_b = 10"), "1");
    const auto area = [&](int room) {
      return std::stod(told(store, "SELECT area_m2 FROM rooms WHERE id = " + std::to_string(room)));
    };
    EXPECT_NEAR(area(5), 33.3 + 5.2 * by_m, 0.2) << "the wall is 5.2 m long";
    EXPECT_NEAR(area(6), 46.8 - 5.2 * by_m - 1.2 * 2.2, 0.2)
        << "and furniture of 1.2 m x 2.2 m is wall";
  }
  static inline Folder* shared_ = nullptr;
  Folder folder_;
};

TEST_F(EditsReplayed, OfTwelveKindsAfterMappingAgainGiveTheSameBytes) {
  const std::string plain = plan_of(store());
  const std::string edits = edits_file(folder_, kAllKinds);
  const Outcome assembled = run("assemble " + store() + " --edits " + edits);
  ASSERT_EQ(assembled.exit_code, 0) << assembled.err;
  EXPECT_THAT(assembled.err, Not(HasSubstr("edits["))) << "each one is applied";
  const std::string edited = plan_of(store());
  EXPECT_NE(edited, plain);
  EXPECT_THAT(edited, HasSubstr(R"("id":9,"name":"Kitchen")"));
  EXPECT_EQ(told(store(), "SELECT verdict FROM closures WHERE from_asr = 28 AND to_asr = 41"),
            "left out as asked");
  EXPECT_EQ(told(store(), "SELECT verdict FROM closures WHERE was_given = 1"), "accepted");

  ASSERT_EQ(run("-q map " + log("m") + " -o " + store()).exit_code, 0);
  ASSERT_EQ(run("-q assemble " + store() + " --jobs 1").exit_code, 0);
  EXPECT_EQ(plan_of(store()), edited) << "mapped again into the store";

  const auto kept = folder_.write(
      "kept.json", told(store(), "SELECT value FROM metadata WHERE key = 'edits_json'"));
  const std::string fresh = (folder_ / "fresh.gpkg").string();
  std::filesystem::copy_file(*shared_ / "mapped_b.gpkg", fresh);
  ASSERT_EQ(run("-q assemble " + fresh + " --edits " + kept.string()).exit_code, 0);
  EXPECT_EQ(plan_of(fresh), edited) << "mapped into a new store, with what the first one keeps";
}

TEST_F(EditsReplayed, EachChangesThePlanButThoseOfClosures) {
  const std::string edits = edits_file(folder_, kAllKinds);
  ASSERT_EQ(run("-q assemble " + store() + " --edits " + edits).exit_code, 0);
  expect_all_kinds(store(), 0.3);
  EXPECT_EQ(told(store(), "SELECT count(*) FROM furniture"), "8") << "one is wall, one was";
}

TEST_F(EditsReplayed, WithAnotherMissionJoinedFitOrAreSaid) {
  const std::string edits = edits_file(folder_, kAllKinds);
  ASSERT_EQ(run("-q assemble " + store() + " --edits " + edits).exit_code, 0);
  const std::string joined = (folder_ / "joined.gpkg").string();
  const Outcome join =
      run("join " + store() + " " + (*shared_ / "other.gpkg").string() + " -o " + joined);
  ASSERT_EQ(join.exit_code, 0) << join.err;
  const std::string as_joined = plan_of(joined);
  const Outcome again = run("assemble " + joined);
  ASSERT_EQ(again.exit_code, 0) << again.err;
  for (const Outcome* outcome : {&join, &again}) {
    EXPECT_THAT(outcome->err, HasSubstr("edits[11] reject_closure: has no effect"));
    EXPECT_THAT(outcome->err, HasSubstr("edits[12] pin_visits: has no effect"));
    EXPECT_THAT(outcome->err, Not(HasSubstr("no longer fits"))) << "all others do";
  }
  EXPECT_EQ(plan_of(joined), as_joined);
  EXPECT_EQ(told(joined, "SELECT name FROM rooms WHERE id = 9"), "Kitchen");
  EXPECT_EQ(told(joined, "SELECT kind FROM rooms WHERE id = 6"), "hall");
  EXPECT_EQ(told(joined, "SELECT count(*) FROM rooms"), "10");

  const std::string far = edits_file(folder_, R"({"edit":"shut_door","at_m":[900.0,0.0]},
    {"edit":"name_room","room":{"at_m":[4.3,12.1],"outline_m":[[4,12],[5,12],[5,13],[4,13]]},
     "name":"Cupboard"})");
  const Outcome lost = run("assemble " + joined + " --edits " + far);
  EXPECT_THAT(lost.err, HasSubstr("edits[0] shut_door: no longer fits and is not applied"));
  EXPECT_THAT(lost.err, HasSubstr("edits[1] name_room: no longer fits and is not applied"));
  EXPECT_EQ(told(joined, "SELECT count(*) FROM rooms WHERE name = 'Cupboard'"), "0");
}

TEST_F(EditsReplayed, OfTwelveKindsAreMadeOnThePageByTheMouse) {
  ROOMATLAS_NEEDS("chromium");
  ROOMATLAS_NEEDS("node");
  const auto assembled_by_page = [&](const std::string& step) {
    const std::string page = (folder_ / "report.html").string();
    EXPECT_EQ(run("-q report " + store() + " -o " + page).exit_code, 0);
    const Outcome clicked = run_other("timeout 300 node " + std::string(ROOMATLAS_SOURCE_DIR) +
                                      "/tests/apps/browser/all_kinds.mjs " + page + " " +
                                      (folder_ / "profile").string() + " " + step);
    EXPECT_EQ(clicked.exit_code, 0) << clicked.err;
    const auto saved = folder_.write("saved.json", clicked.out);
    const Outcome assembled = run("assemble " + store() + " --edits " + saved.string());
    EXPECT_EQ(assembled.exit_code, 0) << assembled.err;
    EXPECT_THAT(assembled.err, Not(HasSubstr("edits["))) << "each one is applied";
    std::string kinds;
    const Json edits = Json::parse(clicked.out);
    for (const Json& one : edits["edits"]) kinds += one["edit"].get<std::string>() + " ";
    return kinds;
  };
  const std::string first =
      "name_room set_room_kind join_rooms split_room shut_door shut_door open_door add_door "
      "move_wall furniture_to_wall reject_closure pin_visits ";
  EXPECT_EQ(assembled_by_page("1"), first);
  expect_all_kinds(store(), 0.2);
  EXPECT_EQ(told(store(), "SELECT count(*) FROM furniture"), "7") << "one is a pillar";
  EXPECT_EQ(assembled_by_page("2"), first + "wall_to_furniture ");
  EXPECT_EQ(told(store(), "SELECT count(*) FROM furniture"), "8") << "the pillar is none";
}

}  // namespace
}  // namespace roomatlas::test
