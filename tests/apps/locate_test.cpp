// SPDX-License-Identifier: GPL-3.0-or-later
// `locate` as a user runs it: pieces of a mission in the building that it was mapped to.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "random_store.hpp"
#include "roomatlas/io/trajectories/tum.hpp"

namespace roomatlas::test {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;

class Locate : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new Folder;
    simulate("there", "two_rooms", "--sensor laser --tour --seed 1");
    const Outcome built = run("-q build " + log("there") + " -o " + (*folder_ / "map").string());
    EXPECT_EQ(built.exit_code, 0) << built.err;
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }

  static void simulate(const std::string& name, const std::string& world,
                       const std::string& flags) {
    const std::string file =
        std::string(ROOMATLAS_SOURCE_DIR) + "/data/worlds/" + world + ".geojson";
    const Outcome made =
        run("-q simulate " + file + " " + flags + " -o " + (*folder_ / name).string());
    EXPECT_EQ(made.exit_code, 0) << made.err;
  }
  static std::string log(const std::string& name) {
    return (*folder_ / name / "mission.clf").string();
  }
  static std::string store() { return (*folder_ / "map/building.gpkg").string(); }

  static inline Folder* folder_ = nullptr;
};

TEST_F(Locate, PutsEachReadingWhereTheWholeMissionsCorrectionHasIt) {
  const Trajectory whole = read_tum(*folder_ / "map/trajectory_corrected.tum");
  const double from_s = whole[whole.size() / 3].timestamp_s;
  const double to_s = whole[whole.size() * 2 / 3].timestamp_s;
  const std::string out = (*folder_ / "where.tum").string();
  const Outcome done = run("-q locate " + store() + " " + log("there") + " --from " +
                           std::to_string(from_s) + " --to " + std::to_string(to_s) + " -o " + out);
  ASSERT_EQ(done.exit_code, 0) << done.err << done.out;
  std::map<double, Pose2> known;
  for (const StampedPose& pose : whole) known[pose.timestamp_s] = pose.pose;
  const Trajectory found = read_tum(out);
  EXPECT_GT(found.size(), 10U);
  for (const StampedPose& pose : found) {
    const Pose2 off = inverse(known.at(pose.timestamp_s)) * pose.pose;
    EXPECT_LT(off.position().norm(), 0.1) << pose.timestamp_s;
    EXPECT_LT(std::abs(degrees(off.theta_rad)), 2.0);
  }
}

TEST_F(Locate, SaysNowhereOfAnotherBuilding) {
  simulate("elsewhere", "open_hall", "--sensor laser --tour --seed 2");
  const Outcome done = run("-q locate " + store() + " " + log("elsewhere") + " --json");
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const Json json = Json::parse(done.out);
  EXPECT_EQ(json["verdict"], "nothing in common");
  double sum = json["nowhere_odds"];
  for (const Json& place : json["places"]) {
    sum += place["odds"].get<double>();
    EXPECT_LE(place["odds"], json["places"][0]["odds"]);  // the likeliest first
  }
  EXPECT_NEAR(sum, 1.0, 1e-9);
}

TEST_F(Locate, NamesTheSpanWhereItHoldsNoReading) {
  const Outcome done = run("-q locate " + store() + " " + log("there") + " --from 5 --to 6");
  EXPECT_EQ(done.exit_code, 3);
  EXPECT_THAT(done.err, HasSubstr("no reading between --from 5 and --to 6; the log runs from"));
}

}  // namespace
}  // namespace roomatlas::test
