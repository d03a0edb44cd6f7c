// SPDX-License-Identifier: GPL-3.0-or-later
// `join` and `build` of several logs as a user runs them: missions of simulated rooms.
#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "joined_missions.hpp"
#include "roomatlas/io/trajectories/tum.hpp"

namespace roomatlas::test {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;

TEST_F(Join, EachLogHasAStoreOfItsOwnHoweverTheyAreNamed) {
  const std::filesystem::path out = *folder_ / "named";
  std::filesystem::create_directory(*folder_ / "other");
  const std::string same = (*folder_ / "other/one.clf").string();
  const std::string numbered = (*folder_ / "other/one-2.clf").string();
  std::filesystem::copy_file(two_, same);
  std::filesystem::copy_file(one_, numbered);
  const std::string logs = one_ + " " + same + " " + numbered;
  ASSERT_EQ(run("-q build " + logs + " -o " + out.string()).exit_code, 0);
  std::set<std::string> stores;
  for (const auto& entry : std::filesystem::directory_iterator(out / "missions")) {
    stores.insert(entry.path().filename());
  }
  EXPECT_EQ(stores, (std::set<std::string>{"one.gpkg", "one-2.gpkg", "one-2-2.gpkg"}));
}

TEST_F(Join, BuildOfTwoLogsIsOneBuildingWhateverTheirOrder) {
  const std::string first = built_folder();
  const std::string second = (*folder_ / "second").string();
  EXPECT_THAT(built().err, HasSubstr("joined:"));
  const Outcome other = run("build " + two_ + " " + one_ + " -o " + second + " --jobs 1");
  ASSERT_EQ(other.exit_code, 0) << other.err;
  EXPECT_THAT(other.err, HasSubstr("one.clf is where the building's frame is from"));
  ASSERT_NE(content_of(first + "/plan.local.geojson"), "");
  EXPECT_EQ(content_of(first + "/plan.local.geojson"), content_of(second + "/plan.local.geojson"));
  EXPECT_EQ(content_of(first + "/plan.svg"), content_of(second + "/plan.svg"));

  // Assembled again, the visits stay where joining put them.
  ASSERT_EQ(run("-q assemble " + second + "/building.gpkg").exit_code, 0);
  ASSERT_EQ(run("-q export " + second + "/building.gpkg -f geojson -o " + second).exit_code, 0);
  EXPECT_EQ(content_of(first + "/plan.local.geojson"), content_of(second + "/plan.local.geojson"));

  // Each mission's path has a file of its own: their times may be the same.
  for (const char* name : {"/trajectory_corrected.1.tum", "/trajectory_corrected.2.tum"}) {
    const Trajectory path = read_tum(first + name);
    EXPECT_TRUE(std::is_sorted(path.begin(), path.end(), [](const auto& a, const auto& b) {
      return a.timestamp_s < b.timestamp_s;
    })) << name;
    EXPECT_GT(path.size(), 100U);
  }

  const GeoPackageStore store(first + "/building.gpkg", GeoPackageStore::Mode::read);
  EXPECT_EQ(store.plan().rooms.size(), 2U);
  const std::vector<MemberMission> members = store.members();
  ASSERT_EQ(members.size(), 2U);
  EXPECT_TRUE(members[0].is_base);
  EXPECT_FALSE(members[1].is_base);
  EXPECT_EQ(members[1].first_asr, members[0].last_asr + 1);
  EXPECT_GT(members[1].agreement, 0.9);
  EXPECT_EQ(store.ids().back(), members[1].last_asr);
}

TEST_F(Join, NamesStayWhenALargerMissionComes) {
  const std::string place = (*folder_ / "larger").string();
  const std::string store = place + "/building.gpkg";
  ASSERT_EQ(run("build " + two_ + " -o " + place).exit_code, 0);
  ASSERT_EQ(run("-q rename " + store + " 1 Kitchen").exit_code, 0);
  const Outcome both = run("build " + two_ + " " + one_ + " -o " + place);
  ASSERT_EQ(both.exit_code, 0) << both.err;
  EXPECT_THAT(both.err, HasSubstr("two.clf is where the building's frame is from"));
  EXPECT_EQ(GeoPackageStore(store, GeoPackageStore::Mode::read).plan().rooms[0].name, "Kitchen");
  // where nobody named anything it is one.clf: BuildOfTwoLogsIsOneBuildingWhateverTheirOrder
}

TEST_F(Join, NamesAndCorrectionsOfTheBuildingStayWhenItIsBuiltAgain) {
  const std::string place = (*folder_ / "kept").string();
  const std::string store = place + "/building.gpkg";
  const std::string build = "build " + one_ + " " + two_ + " -o " + place;
  const auto names = [&](const std::string& file) {
    std::vector<std::string> found;
    for (const PlanRoom& room : GeoPackageStore(file, GeoPackageStore::Mode::read).plan().rooms) {
      found.push_back(room.name);
    }
    return found;
  };
  std::ofstream(*folder_ / "kinds.json")
      << R"({"format": "roomatlas-edits", "version": 1, "frame": "building", "edits": [{"edit": "set_room_kind", "room": {"id": 1}, "kind": "hall"}]})";
  ASSERT_EQ(run(build + " --edits " + (*folder_ / "kinds.json").string()).exit_code, 0);
  ASSERT_EQ(run("-q rename " + store + " 2 Kitchen").exit_code, 0);
  const Outcome again = run(build);
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(names(store), ::testing::ElementsAre("1", "Kitchen"));
  EXPECT_EQ(GeoPackageStore(store, GeoPackageStore::Mode::read).plan().rooms[0].kind,
            RoomKind::hall);

  // `join` onto a building of before does the same, and takes names that the base alone has.
  const std::string stores = place + "/missions/one.gpkg " + place + "/missions/two.gpkg";
  for (const char* mission : {"one", "two"}) {
    const std::string single = place + "/missions/" + mission + ".gpkg";
    ASSERT_EQ(run("-q rename " + single + " 1 Office").exit_code, 0);
    ASSERT_EQ(run("-q rename " + single + " 2 Pantry").exit_code, 0);
  }
  ASSERT_EQ(run("-q join " + stores + " -o " + store).exit_code, 0);
  EXPECT_THAT(names(store), ::testing::ElementsAre("Office", "Kitchen"));

  // Another building's frame is another: what was there stays beside.
  const std::string other = log("stranger", "two_rooms", "--sensor laser --tour --seed 9");
  ASSERT_EQ(run("-q build " + other + " -o " + place + "/other").exit_code, 0);
  std::filesystem::copy_file(store, place + "/other/building.gpkg",
                             std::filesystem::copy_options::overwrite_existing);
  const Outcome lost = run("build " + other + " -o " + place + "/other");
  ASSERT_EQ(lost.exit_code, 0) << lost.err;
  EXPECT_THAT(lost.err, HasSubstr("the room \"Office\", the room \"Kitchen\", 4 corrections"));
  EXPECT_THAT(names(place + "/other/building.former.gpkg"),
              ::testing::ElementsAre("Office", "Kitchen"));
}

TEST_F(Join, SaysOfEachMissionWhatItSawAndHowFarItIsOffTheTruth) {
  const std::string place = built_folder();
  // Both logs tell the time from the same start, and each brings its own true poses.
  const Json json = Json::parse(built().out);
  const Json& missions = json.at("missions");
  ASSERT_EQ(missions.at("list").size(), 2U);
  std::vector<std::string> names;
  std::int64_t poses = 0;
  for (const Json& mission : missions["list"]) {
    names.push_back(mission["name"]);
    EXPECT_EQ(mission["rooms"].size(), 2U);
    EXPECT_GT(mission["seen_share"].get<double>(), 0.8);
    EXPECT_LE(mission["seen_share"].get<double>(), 1.0);
    EXPECT_LT(mission["walls_rms_m"].get<double>(), 0.05);
    EXPECT_LT(mission["in_building"]["position_m"]["max"].get<double>(), 0.1);
    poses += mission["true_poses"]["after"]["matched"].get<std::int64_t>();
  }
  EXPECT_THAT(names, ::testing::UnorderedElementsAre("one.clf", "two.clf"));
  EXPECT_EQ(json["true_poses"]["after"]["matched"].get<std::int64_t>(), poses);
  EXPECT_LT(json["true_poses"]["after"]["fitted_position_m"]["max"].get<double>(), 0.1);
  ASSERT_EQ(missions["pairs"].size(), 1U);
  EXPECT_LT(missions["pairs"][0]["rms_m"].get<double>(), 0.05);
  EXPECT_EQ(Json::parse(content_of(place + "/summary.json"))["evaluation"]["missions"], missions);
  EXPECT_THAT(content_of(place + "/report.html"), HasSubstr("Who saw which room when"));

  // Truth that is somebody else's makes its mission wrong, and no other.
  const std::string store = place + "/building.gpkg";
  const std::string first = (*folder_ / "one" / "truth.tum").string();
  EXPECT_EQ(run("evaluate " + store + " --truth " + first).exit_code, 2);  // whose is it?
  EXPECT_EQ(run("evaluate " + store + " --truth three=" + first).exit_code, 2);
  Trajectory wrong = read_tum(first);
  for (StampedPose& pose : wrong) pose.pose.x_m *= 1.5;
  const std::string stretched = (*folder_ / "stretched.tum").string();
  write_tum(stretched, wrong);
  const Outcome judged = run("-q --json evaluate " + store + " --truth one=" + stretched);
  ASSERT_EQ(judged.exit_code, 0) << judged.err;
  const Json told = Json::parse(judged.out);
  for (const Json& mission : told["plans"][0]["missions"]["list"]) {
    const double fitted_m =
        mission["true_poses"]["after"]["fitted_position_m"]["rmse"].get<double>();
    EXPECT_EQ(fitted_m > 0.3, mission["name"] == "one.clf") << mission["name"] << " " << fitted_m;
  }
}

TEST_F(Join, AddsAMissionToABuildingThatKeepsItsRooms) {
  const std::string place = copy_of_built("grown");
  ASSERT_EQ(run("-q rename " + place + "/building.gpkg 2 Kitchen").exit_code, 0);
  const std::string three = log("three", "two_rooms", "--sensor sonar --tour --seed 3");
  ASSERT_EQ(run("-q map " + three + " -o " + place + "/three.gpkg").exit_code, 0);
  ASSERT_EQ(run("-q assemble " + place + "/three.gpkg").exit_code, 0);
  const std::string grown = place + "/grown.gpkg";
  const Outcome done = run("join " + place + "/three.gpkg " + place + "/building.gpkg -o " + grown);
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const GeoPackageStore store(grown, GeoPackageStore::Mode::read);
  ASSERT_EQ(store.members().size(), 3U);
  EXPECT_EQ(store.members()[2].sensor, SensorKind::sonar);
  std::vector<std::string> names;
  for (const PlanRoom& room : store.plan().rooms) names.push_back(room.name);
  EXPECT_THAT(names, ::testing::Contains("Kitchen"));
}

TEST_F(Join, TakesANameOfItsBaseThatWaitsForItsRoom) {
  const std::string place = copy_of_built("waiting");
  const std::string stores[] = {place + "/missions/one.gpkg", place + "/missions/two.gpkg"};
  for (const std::string& store : stores) {
    const auto rooms = GeoPackageStore(store, GeoPackageStore::Mode::read).plan().rooms;
    ASSERT_EQ(rooms.size(), 2U);
    const double middle_m2 = (rooms[0].area_m2 + rooms[1].area_m2) / 2.0;
    const std::string small = rooms[0].area_m2 < middle_m2 ? "1" : "2";
    ASSERT_EQ(run("-q rename " + store + " " + small + " Pantry").exit_code, 0);
    ASSERT_EQ(run("-q assemble " + store + " --min-room " + std::to_string(middle_m2)).exit_code,
              0);
    ASSERT_EQ(GeoPackageStore(store, GeoPackageStore::Mode::read).plan().rooms.size(), 1U);
  }
  const std::string joined = place + "/joined.gpkg";
  ASSERT_EQ(run("-q join " + stores[0] + " " + stores[1] + " -o " + joined).exit_code, 0);
  const auto rooms = GeoPackageStore(joined, GeoPackageStore::Mode::read).plan().rooms;
  ASSERT_EQ(rooms.size(), 2U);
  EXPECT_TRUE(rooms[0].name == "Pantry" || rooms[1].name == "Pantry");
}

TEST_F(Join, ABuildingBesideTheFirstIsKeptFromOthersAsThatOneIs) {
  const std::string hall = log("hall", "open_hall", "--sensor laser --max-time 60 --seed 4");
  const std::string again = log("again", "open_hall", "--sensor laser --max-time 60 --seed 6");
  const std::string place = (*folder_ / "buildings").string();
  const std::string build = "build " + one_ + " " + two_ + " " + hall + " " + again;
  const Outcome done = run(build + " -o " + place);
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_THAT(done.err, ::testing::Not(HasSubstr("of an earlier run")));
  const std::string second = place + "/building.2.gpkg";
  {
    SQLite::Database other(second, SQLite::OPEN_READWRITE);
    other.exec("PRAGMA journal_mode = WAL; CREATE TABLE notes (note TEXT)");
    const Outcome refused =
        run("-q join " + place + "/missions/*.gpkg -o " + place + "/building.gpkg");
    EXPECT_EQ(refused.exit_code, 3);
    EXPECT_THAT(refused.err, HasSubstr("building.2.gpkg: another program has it open"));
    other.exec("INSERT INTO notes VALUES ('ours')");
  }
  const Outcome alone = run("build " + one_ + " " + two_ + " -o " + place);
  EXPECT_THAT(alone.err, HasSubstr("not written now: beside/building.2, building.2.gpkg"));
}

TEST_F(Join, DrawsWhatSomeOfTheMissionsSawAlone) {
  const std::string half = log("half", "two_rooms", "--sensor laser --seed 5 --max-time 40");
  const std::string place = (*folder_ / "some").string();
  ASSERT_EQ(run("-q build " + one_ + " " + half + " -o " + place).exit_code, 0);
  const std::string store = place + "/building.gpkg";
  const auto area_m2 = [](const std::string& file) {
    double sum = 0.0;
    const FloorPlan plan = GeoPackageStore(file, GeoPackageStore::Mode::read).plan();
    for (const PlanRoom& room : plan.rooms) sum += room.area_m2;
    return sum;
  };
  const double all_m2 = area_m2(store);
  const double half_m2 = area_m2(place + "/missions/half.gpkg");
  ASSERT_GT(std::abs(half_m2 - all_m2), 0.3);  // a short drive leaves corners out
  ASSERT_EQ(run("-q assemble " + store + " --missions half").exit_code, 0);
  EXPECT_NEAR(area_m2(store), half_m2, 0.15);
  ASSERT_EQ(run("-q assemble " + store + " --missions 1,2").exit_code, 0);
  EXPECT_NEAR(area_m2(store), all_m2, 1e-3);
  EXPECT_EQ(run("-q assemble " + store + " --missions other").exit_code, 2);
  EXPECT_EQ(run("-q assemble " + place + "/missions/one.gpkg --missions 1").exit_code, 2);
}

TEST_F(Join, GivesAVisitThatLiesInNoRoomToTheNearest) {
  const std::string place = copy_of_built("beyond");
  const std::string store = place + "/building.gpkg";
  SQLite::Database(store, SQLite::OPEN_READWRITE)
      .exec(
          "UPDATE corrections SET after_x_m = after_x_m + 50 "
          "WHERE asr = (SELECT last_asr FROM missions WHERE id = 2)");
  const Outcome done = run("-q assemble " + store + " --missions 1");
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(GeoPackageStore(store, GeoPackageStore::Mode::read).plan().rooms.size(), 2U);

  // Nor is there a nearest where there is none.
  const Outcome without = run("-q assemble " + store + " --missions 1 --min-room 100");
  EXPECT_EQ(without.exit_code, 4) << without.err;  // it says so, and writes all files
  EXPECT_EQ(GeoPackageStore(store, GeoPackageStore::Mode::read).plan().rooms.size(), 0U);
}

TEST_F(Join, LeavesAMissionOfAnotherBuildingAloneAndSaysSo) {
  const std::string other = log("other", "open_hall", "--sensor laser --tour --seed 4");
  const std::string place = (*folder_ / "apart").string();
  const Outcome done = run("build " + one_ + " " + other + " -o " + place);
  EXPECT_EQ(done.exit_code, 4);
  EXPECT_THAT(done.err, HasSubstr("nothing holds any two of these missions together"));
  EXPECT_TRUE(std::filesystem::exists(place + "/missions/one.gpkg"));
  EXPECT_TRUE(std::filesystem::exists(place + "/missions/other.gpkg"));
  EXPECT_FALSE(std::filesystem::exists(place + "/building.gpkg"));
}

TEST_F(Join, RefusesAnOtherAnswerThatIsNotOfTheVisits) {
  const std::string place = copy_of_built("answers");
  const std::string stores[] = {place + "/missions/one.gpkg", place + "/missions/two.gpkg"};
  for (const char* damaged :
       {R"({"visits":[[1, 0, 0, 0]]})", R"({"visits":[[1, 0, 0]]})", "[]", ""}) {
    {
      GeoPackageStore store(stores[1], GeoPackageStore::Mode::update);
      store.put_metadata({{"other_answer_json", damaged}});
    }
    const Outcome done = run("-q join " + stores[0] + " " + stores[1] + " -o " +
                             (*folder_ / "damaged.gpkg").string());
    if (std::string(damaged).empty()) {
      EXPECT_EQ(done.exit_code, 0) << done.err;
    } else {
      EXPECT_EQ(done.exit_code, 3) << damaged << done.err;
      EXPECT_THAT(done.err, HasSubstr("other_answer_json")) << damaged;
    }
  }
}

}  // namespace
}  // namespace roomatlas::test
