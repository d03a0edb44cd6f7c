// SPDX-License-Identifier: GPL-3.0-or-later
// What `build` and `export` say they made, against what is there.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>

#include "program.hpp"

namespace roomatlas::test {
namespace {

using Json = nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// A mission through two rooms, made once.
const Folder& made() {
  static const Folder folder;
  static const Outcome simulated =
      run("-q simulate " + std::string(ROOMATLAS_SOURCE_DIR) +
          "/data/worlds/two_rooms.geojson --sensor laser -o " + (folder / "mission").string());
  EXPECT_EQ(simulated.exit_code, 0) << simulated.err;
  return folder;
}

std::string log_file() { return (made() / "mission" / "mission.clf").string(); }

std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

TEST(BuildReport, EndsWithRoomsDoorsTrustAndWhatToOpenFirst) {
  const Folder folder;
  const std::string out = (folder / "out").string();
  const Outcome built = run("build " + log_file() + " -o " + out);
  ASSERT_EQ(built.exit_code, 0) << built.err;
  EXPECT_THAT(built.out,
              AllOf(HasSubstr("2 rooms, "), HasSubstr("\n1 door\n"), HasSubstr(" m2\n"),
                    HasSubstr("room"), HasSubstr("accuracy: "), HasSubstr("with a probability of "),
                    HasSubstr("open first: " + out + "/report.html")));
  EXPECT_THAT(built.out, AllOf(Not(HasSubstr("negative walls")), Not(HasSubstr("vote"))));
  EXPECT_THAT(run("-v build " + log_file() + " -o " + out).out, HasSubstr("negative walls"));
}

TEST(BuildReport, AsJsonHasRoomsDoorsFilesAndFigures) {
  const Folder folder;
  const std::filesystem::path out = folder / "out";
  const Outcome built = run("-q --json build " + log_file() + " -o " + out.string());
  ASSERT_EQ(built.exit_code, 0) << built.err;
  const Json json = Json::parse(built.out);
  const Json plan = Json::parse(content_of(out / "plan.local.geojson"));
  std::size_t rooms = 0;
  double area_m2 = 0.0;
  for (const Json& feature : plan["features"]) {
    const std::string kind = feature["properties"]["kind"];
    if (kind != "room" && kind != "corridor" && kind != "hall") continue;
    ++rooms;
    area_m2 += feature["properties"]["area_m2"].get<double>();
  }
  ASSERT_EQ(json["rooms"].size(), rooms);
  for (const Json& room : json["rooms"]) area_m2 -= room["area_m2"].get<double>();
  EXPECT_NEAR(area_m2, 0.0, 0.01);
  ASSERT_EQ(json["doors"].size(), 1U);
  EXPECT_EQ(json["doors"][0]["rooms"], Json({1, 2}));
  EXPECT_TRUE(json.contains("true_poses"));
  EXPECT_THAT(json["trust"].get<std::string>(), HasSubstr("probability"));
  EXPECT_EQ(json["files"].get<std::set<std::string>>(), names_in(out));
}

TEST(ExportReport, NamesEveryFileThatIsWritten) {
  const Folder folder;
  ASSERT_EQ(run("-q build " + log_file() + " -o " + (folder / "out").string()).exit_code, 0);
  const std::string store = (folder / "out" / "building.gpkg").string();
  const std::filesystem::path all = folder / "all";
  const Outcome told = run("--json export " + store + " --georef 48,7.8,0 -o " + all.string());
  ASSERT_EQ(told.exit_code, 0) << told.err;
  EXPECT_EQ(Json::parse(told.out)["files"].get<std::set<std::string>>(), names_in(all));
  const Outcome one = run("export " + store + " -f csv -o " + (folder / "one").string());
  EXPECT_EQ(one.out, "1 file in " + (folder / "one").string() + ":\n  rooms.csv\n");
  EXPECT_THAT(run("export " + store + " -f geojsno -o " + all.string()).err,
              HasSubstr("did you mean geojson?"));
}

TEST(Simulate, DrivesThroughTheMapThatBuildHasWritten) {
  const Folder folder;
  const std::string out = (folder / "out").string();
  ASSERT_EQ(run("-q build " + log_file() + " -o " + out).exit_code, 0);
  for (const std::string& world :
       {out + "/map.yaml", out + "/map.pgm --resolution 0.05", out + "/plan.local.geojson"}) {
    const Outcome driven = run("--json simulate " + world + " --sensor laser --max-time 120 -o " +
                               (folder / "again").string());
    ASSERT_EQ(driven.exit_code, 0) << driven.err;
    const Json told = Json::parse(driven.out);
    EXPECT_TRUE(told["finished"].get<bool>()) << world;
    EXPECT_GT(told["path_length_m"].get<double>(), 2.0) << world;  // through the door
  }
}

}  // namespace
}  // namespace roomatlas::test
