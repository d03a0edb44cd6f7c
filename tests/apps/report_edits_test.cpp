// SPDX-License-Identifier: GPL-3.0-or-later
// The report page's editor in Chromium, used by pointer, fingers and keys: from there to the plan.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "edited_store.hpp"

namespace roomatlas::test {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

class ReportEdits : public Edits {
 protected:
  void SetUp() override {
    Edits::SetUp();
    ROOMATLAS_NEEDS("chromium");
    ROOMATLAS_NEEDS("node");
    ASSERT_EQ(run("-q report " + store() + " -o " + page()).exit_code, 0);
  }
  [[nodiscard]] std::string page() const { return (folder_ / "report.html").string(); }

  /// What a script of tests/apps/browser prints that used the page.
  [[nodiscard]] Json used(const std::string& script, const std::string& arguments) const {
    const Outcome done =
        run_other("timeout 300 node " + std::string(ROOMATLAS_SOURCE_DIR) + "/tests/apps/browser/" +
                  script + " " + page() + " " + (folder_ / "profile").string() + " " + arguments);
    EXPECT_EQ(done.exit_code, 0) << done.err;
    return done.exit_code == 0 ? Json::parse(done.out) : Json();
  }
  /// The kinds of statements, in their order.
  static std::string kinds(const Json& edits) {
    std::string kinds;
    for (const Json& one : edits["edits"]) kinds += one["edit"].get<std::string>() + " ";
    return kinds;
  }
  /// A copy of the store, assembled with what the page would save.
  [[nodiscard]] std::string assembled(const Json& edits, Outcome& outcome) const {
    const auto file = folder_.write("saved.json", edits.dump());
    const std::string copy = (folder_ / "copy.gpkg").string();
    std::filesystem::copy_file(store(), copy, std::filesystem::copy_options::overwrite_existing);
    outcome = run("assemble " + copy + " --edits " + file.string());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, Not(HasSubstr("no longer fits")));
    return copy;
  }
  /// The area of each room of a store's plan, in the order of their numbers.
  [[nodiscard]] std::vector<double> areas(const std::string& store) const {
    const std::string out = (folder_ / "rooms").string();
    EXPECT_EQ(run("-q export " + store + " -f geojson -o " + out).exit_code, 0);
    std::vector<double> areas;
    const Json plan = Json::parse(content_of(out + "/plan.local.geojson"));
    for (const Json& one : plan["features"]) {
      if (one["properties"].contains("area_m2")) areas.push_back(one["properties"]["area_m2"]);
    }
    return areas;
  }
};

TEST_F(ReportEdits, FromAClickOnThePageToThePlan) {
  for (const char* size : {"1440 1000", "390 844"}) {
    const Json saved = used("click_edits.mjs", size);
    EXPECT_EQ(kinds(saved), "name_room set_room_kind shut_door split_room ") << size;
    Outcome outcome;
    (void)assembled(saved, outcome);
    EXPECT_THAT(outcome.err, HasSubstr("3 rooms, 0 doors, 1 passage\n"));
  }
}

/// The wall between the rooms, which have 20.6 and 24.9 m2, is 4.30 m long.
TEST_F(ReportEdits, AWallIsMovedByClicksByDraggingByAFingerAndByANumber) {
  const std::vector<double> before = areas(store());
  ASSERT_EQ(before.size(), 2U);
  const std::pair<const char*, double> ways[] = {
      {"1440 1000 2.33,1.0 2.16,1.1 click", -0.25},
      {"1440 1000 2.33,1.0 2.16,1.1 drag", -0.25},
      {"390 844 2.33,1.0 1.91,1.1 touch", -0.5},
      {"768 1000 2.33,1.0 0,0 0.123", -0.123},
  };
  for (const auto& [how, by_m] : ways) {
    const Json saved = used("move_wall.mjs", how);
    ASSERT_EQ(kinds(saved), "move_wall ") << how;
    EXPECT_NEAR(saved["edits"][0]["by_m"].get<double>(), -by_m, 1e-9) << how;
    Outcome outcome;
    const std::vector<double> after = areas(assembled(saved, outcome));
    ASSERT_EQ(after.size(), 2U) << how;
    EXPECT_NEAR(after[0] - before[0], 4.3 * by_m, 0.05) << how;
    EXPECT_NEAR(after[1] - before[1], -4.3 * by_m, 0.05) << how;
  }
}

TEST_F(ReportEdits, AMatchIsRejectedAndRoomsArePinned) {
  const Json done = used("closures.mjs", "1440 1000");
  ASSERT_EQ(kinds(done["edits"]), "reject_closure pin_visits ");
  Outcome outcome;
  const std::string copy = assembled(done["edits"], outcome);
  SQLite::Database db(copy);
  SQLite::Statement closures(
      db, "SELECT from_asr, to_asr, verdict FROM closures WHERE was_given = ? ORDER BY id");
  closures.bind(1, 0);
  ASSERT_TRUE(closures.executeStep()) << "found by itself";
  EXPECT_EQ(closures.getColumn(0).getInt(), done["rejected"]["from"].get<int>());
  EXPECT_EQ(closures.getColumn(1).getInt(), done["rejected"]["to"].get<int>());
  EXPECT_EQ(closures.getColumn(2).getString(), "left out as asked");
  closures.reset();
  closures.bind(1, 1);
  ASSERT_TRUE(closures.executeStep()) << "pinned";
  EXPECT_EQ(closures.getColumn(0).getInt(), done["pinned"]["first"].get<int>());
  EXPECT_EQ(closures.getColumn(1).getInt(), done["pinned"]["second"].get<int>());
  EXPECT_EQ(closures.getColumn(2).getString(), "accepted");
}

TEST_F(ReportEdits, FingersMoveAndZoomTheMapAndCorrectThePlan) {
  const Json done = used("touch.mjs", "390 844");
  // Leaflet begins to move the map where the finger has gone a few pixels.
  EXPECT_NEAR(done["moved_m"], done["expected_m"], 0.2 * done["expected_m"].get<double>());
  EXPECT_GE(done["zoomed"], 1.0);
  EXPECT_EQ(done["small"], Json::array()) << "controls that a finger would miss";
  EXPECT_EQ(done["jumped"], 0) << "a tap on the map leaves the page where it is";
  EXPECT_EQ(done["tooWide"], false);
  EXPECT_EQ(done["fetched"], Json::array());
  EXPECT_EQ(done["complaints"], Json::array());
  ASSERT_EQ(kinds(done["edits"]), "name_room shut_door ");
  Outcome outcome;
  (void)assembled(done["edits"], outcome);
  EXPECT_THAT(outcome.err, HasSubstr("2 rooms, 0 doors\n"));
}

TEST_F(ReportEdits, NoWidthOfTheWindowScrollsSideways) {
  const Json done = used("widths.mjs", "");
  EXPECT_EQ(done["tooWide"], Json::array());
  EXPECT_EQ(done["complaints"], Json::array());
  EXPECT_THAT(done["tables"], ::testing::Contains("errors")) << "the log has true poses";
}

TEST_F(ReportEdits, KeysAloneDoItAndAScreenReaderHasAll) {
  const Json done = used("keyboard.mjs", "1440 1000");
  ASSERT_EQ(kinds(done["edits"]), "name_room move_wall shut_door ");
  EXPECT_EQ(done["edits"]["edits"][1]["by_m"], 0.2);
  for (const char* stop : {"map", "edit", "edit-undo", "edit-save", "moment", "search", "shut"}) {
    EXPECT_THAT(done["reached"], ::testing::Contains(stop));
  }
  EXPECT_EQ(done["unseen"], Json::array()) << "stops of the tab key without a visible focus";
  EXPECT_EQ(done["nameless"], Json::array()) << "controls without a name";
  EXPECT_GT(done["controls"], 30);
  EXPECT_THAT(
      done["pictures"],
      ::testing::Contains("Floor plan; rooms: 2, doors: 1. The table of rooms lists them."));
  EXPECT_THAT(done["rows"], ::testing::Contains(Json({"1", "1", "room", "20.6", "1"})));
  EXPECT_THAT(done["rows"], ::testing::Contains(Json({"2", "2", "room", "24.9", "1"})));
  EXPECT_EQ(done["announced"],
            Json({"Choose a room, then write its name or set its kind.", "Room 1: done.",
                  "Let go. Choose two rooms that are one.", "Wall moved by 0.20 m.",
                  "Undone: move wall by 0.20 m.", "Done again: move wall by 0.20 m.",
                  "shut door: done. Choose a door or passage that is wall."}));
  EXPECT_GE(done["live"], 1);
  EXPECT_EQ(done["complaints"], Json::array());
  Outcome outcome;
  (void)assembled(done["edits"], outcome);
  EXPECT_THAT(outcome.err, HasSubstr("2 rooms, 0 doors\n"));
}

}  // namespace
}  // namespace roomatlas::test
