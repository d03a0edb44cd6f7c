// SPDX-License-Identifier: GPL-3.0-or-later
// A simulated robot that is carried to another room in the middle of its mission, as a user sees
// it.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "random_store.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/io/trajectories/tum.hpp"

namespace roomatlas::test {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;

/// The pose of the truth at this time.
Pose2 at(const Trajectory& truth, double time_s) {
  const auto nearest = std::min_element(truth.begin(), truth.end(), [&](auto& a, auto& b) {
    return std::abs(a.timestamp_s - time_s) < std::abs(b.timestamp_s - time_s);
  });
  return nearest->pose;
}

class Carried : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new Folder;
    const std::string world = std::string(ROOMATLAS_SOURCE_DIR) + "/data/worlds/two_rooms.geojson";
    const Outcome made = run("-q simulate " + world +
                             " --sensor laser --tour --seed 1 --start 2.5,1.5,0 --carry-at 60 "
                             "--carry-to 8.5,5,200 -o " +
                             (*folder_ / "carried").string());
    EXPECT_EQ(made.exit_code, 0) << made.err;
    built_ = run("build " + log() + " -o " + (*folder_ / "out").string());
    EXPECT_EQ(built_.exit_code, 0) << built_.err;
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }
  static std::string log() { return (*folder_ / "carried/mission.clf").string(); }

  static inline Folder* folder_ = nullptr;
  static inline Outcome built_;
};

TEST_F(Carried, MissionIsCutAndJoinedAgain) {
  EXPECT_THAT(built_.err, HasSubstr("the robot was carried away between"));
  const GeoPackageStore store(*folder_ / "out/building.gpkg", GeoPackageStore::Mode::read);
  const auto members = store.members();
  ASSERT_EQ(members.size(), 2U);
  std::set<std::string> names;
  for (const MemberMission& member : members) names.insert(member.name);
  EXPECT_EQ(names, (std::set<std::string>{"mission.clf#1", "mission.clf#2"}));
  EXPECT_EQ(store.plan().rooms.size(), 2U);
}

TEST_F(Carried, BothPartsLieInOneFrameWhereTheyWere) {
  const Trajectory truth = read_tum(*folder_ / "carried/truth.tum");
  std::optional<Pose2> world_from_building;
  std::size_t poses = 0;
  for (const char* name : {"out/trajectory_corrected.1.tum", "out/trajectory_corrected.2.tum"}) {
    for (const StampedPose& pose : read_tum(*folder_ / name)) {
      const Pose2 known = at(truth, pose.timestamp_s);
      if (!world_from_building) world_from_building = known * inverse(pose.pose);
      const Pose2 found = *world_from_building * pose.pose;
      EXPECT_LT((found.position() - known.position()).norm(), 0.15) << pose.timestamp_s;
      ++poses;
    }
  }
  EXPECT_EQ(poses, truth.size());
}

TEST_F(Carried, LocateAnswersBeforeAndAfter) {
  const Outcome done = run("-q locate " + (*folder_ / "out/building.gpkg").string() + " " + log() +
                           " --json -o " + (*folder_ / "where.tum").string());
  ASSERT_EQ(done.exit_code, 0) << done.err << done.out;
  const Json json = Json::parse(done.out);
  ASSERT_EQ(json["parts"].size(), 2U);
  const double cut_s = json["parts"][1]["from_s"];
  const Trajectory truth = read_tum(*folder_ / "carried/truth.tum");
  double longest_m = 0.0;
  double longest_s = 0.0;  // the first reading after the longest step is where it was put down
  for (std::size_t i = 1; i < truth.size(); ++i) {
    const double step_m = (truth[i].pose.position() - truth[i - 1].pose.position()).norm();
    if (step_m > longest_m) longest_s = truth[i].timestamp_s;
    longest_m = std::max(longest_m, step_m);
  }
  EXPECT_NEAR(cut_s, longest_s, 0.11);
  for (const Json& part : json["parts"]) EXPECT_EQ(part["verdict"], "placed") << part;
}

TEST_F(Carried, IsOneMissionWhereNobodyAsks) {
  const Outcome done =
      run("build " + log() + " --no-find-kidnappings -o " + (*folder_ / "uncut").string());
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(done.err.find("carried away"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(*folder_ / "uncut/missions"));
}

TEST_F(Carried, PartThatNothingHoldsStaysBeside) {
  const std::string world = std::string(ROOMATLAS_SOURCE_DIR) + "/data/worlds/eight_rooms.geojson";
  const Outcome made = run("-q simulate " + world +
                           " --sensor laser --tour --seed 3 --start 2,2,0 --carry-at 60 "
                           "--carry-to 21,3.5,90 --max-time 110 -o " +
                           (*folder_ / "far").string());
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const Outcome done = run("build " + (*folder_ / "far/mission.clf").string() + " -o " +
                           (*folder_ / "apart").string());
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_THAT(done.err, HasSubstr("not joined"));
  EXPECT_TRUE(std::filesystem::exists(*folder_ / "apart/plan.svg"));
  std::size_t beside = 0;
  for (const auto& part : std::filesystem::directory_iterator(*folder_ / "apart/beside")) {
    EXPECT_TRUE(std::filesystem::exists(part.path() / "plan.svg"));
    ++beside;
  }
  EXPECT_EQ(beside, 1U);

  // What people said of the building stays when it is built again.
  const std::string store = (*folder_ / "apart/building.gpkg").string();
  const auto first_room = [&] {
    return GeoPackageStore(store, GeoPackageStore::Mode::read).plan().rooms.front();
  };
  const std::string id = std::to_string(first_room().id);
  ASSERT_EQ(run("-q rename " + store + " " + id + " Kitchen").exit_code, 0);
  const Outcome again = run("build " + (*folder_ / "far/mission.clf").string() + " -o " +
                            (*folder_ / "apart").string());
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(first_room().name, "Kitchen");
}

}  // namespace
}  // namespace roomatlas::test
