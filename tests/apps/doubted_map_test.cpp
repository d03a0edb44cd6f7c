// SPDX-License-Identifier: GPL-3.0-or-later
// A laser of 16 beams over a right angle that reaches 4 m, on a robot that turns by 5 degrees a
// metre: matched one by one its sweeps lose the way.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace roomatlas::test {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

class DoubtedMap : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new Folder;
    const std::string world = std::string(ROOMATLAS_SOURCE_DIR) + "/data/worlds/eight_rooms";
    const Outcome simulated =
        run("-q simulate " + world +
            ".geojson --sensor laser --laser-view 90 --laser-beams 16 --laser-range 4 "
            "--odometry-bias 5 --tour --max-time 200 --seed 3 -o " +
            path("m"));
    ASSERT_EQ(simulated.exit_code, 0) << simulated.err;
    whole_ = build("whole", "");
    sweeps_ = build("sweeps", " --no-correct-sonars");
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }

  static std::string path(const std::string& name) { return (*folder_ / name).string(); }
  static Outcome build(const std::string& out, const std::string& options) {
    return run("--json build " + path("m/mission.clf") + " --truth " + path("m/truth.tum") +
               " -o " + path(out) + options);
  }
  static double off_m(const Outcome& built) {
    return Json::parse(built.out)["true_poses"]["after"]["fitted_position_m"]["rmse"];
  }
  static double probability(const Outcome& built) {
    return Json::parse(built.out)["judgement"]["probability"];
  }

  static inline Folder* folder_ = nullptr;
  static inline Outcome whole_;   ///< of the mission as a whole
  static inline Outcome sweeps_;  ///< of its sweeps, matched one by one
};

TEST_F(DoubtedMap, IsCorrectedAsAWhole) {
  EXPECT_GT(off_m(sweeps_), 1.0);
  EXPECT_LT(probability(sweeps_), 0.5);
  EXPECT_THAT(sweeps_.err, Not(HasSubstr("corrected as a whole")));
  EXPECT_LT(off_m(whole_), 0.1);
  EXPECT_THAT(whole_.err, HasSubstr("corrected as a whole"));
}

TEST_F(DoubtedMap, SaysThatItWasDoubted) {
  EXPECT_GT(probability(whole_), probability(sweeps_));
  EXPECT_LT(probability(whole_), 0.9);
  EXPECT_THAT(whole_.err, HasSubstr("its sweeps, matched one by one, made another map"));
}

TEST_F(DoubtedMap, IsAssembledAgainToTheSameBytes) {
  const std::string store = path("again.gpkg");
  std::filesystem::copy_file(path("whole/building.gpkg"), store);
  ASSERT_EQ(run("-q assemble " + store + " --jobs 3").exit_code, 0);
  EXPECT_TRUE(content_of(store) == content_of(path("whole/building.gpkg")));
}

TEST_F(DoubtedMap, StaysAsItsMatchesMakeItWhereSomebodyPinnedVisits) {
  const std::string visits = R"("from_time_s":1000000001.0,"to_time_s":1000000150.0)";
  const std::string edits =
      R"({"format":"roomatlas-edits","version":1,"frame":"building","edits":[)";
  const auto rejected =
      folder_->write("rejected.json", edits + R"({"edit":"reject_closure",)" + visits + "}]}");
  const auto pinned = folder_->write(
      "pinned.json", edits + R"({"edit":"pin_visits",)" + visits +
                         R"(,"from_from_to":{"x_m":0.0,"y_m":0.0,"theta_rad":0.0}}]})");
  const std::string store = path("edited.gpkg");
  std::filesystem::copy_file(path("whole/building.gpkg"), store);
  EXPECT_THAT(run("assemble " + store + " --edits " + rejected.string()).err,
              HasSubstr("corrected as a whole"));
  const Outcome outcome = run("assemble " + store + " --edits " + pinned.string());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, Not(HasSubstr("corrected as a whole")));
}

}  // namespace
}  // namespace roomatlas::test
