// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/temporary_folder.hpp"

#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/logs/drive.hpp"
#include "roomatlas/io/trajectories/relations.hpp"
#include "roomatlas/io/trajectories/tum.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace roomatlas {
namespace {

using test::bytes_of;
using test::TemporaryFolder;
using ::testing::HasSubstr;

template <typename Call>
std::string refusal_by(Call call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

TEST(Tum, RoundTripKeepsEveryBitOfTimesAndPositionsAndTheHeading) {
  const TemporaryFolder folder;
  Trajectory trajectory;
  for (int i = 0; i < 2000; ++i) {
    const double t = 1134864629.895182 + 0.1 * i;
    trajectory.push_back({t, {std::sin(t) * 1e3, 1e-7 / (i + 1), wrap_angle(0.37 * i)}});
  }
  trajectory.push_back({-1e-300, {1e300, -1.0 / 3.0, -kPi}});
  write_tum(folder / "path.tum", trajectory);
  const Trajectory again = read_tum(folder / "path.tum");
  ASSERT_EQ(again.size(), trajectory.size());
  for (std::size_t i = 0; i < again.size(); ++i) {
    EXPECT_EQ(again[i].timestamp_s, trajectory[i].timestamp_s);
    EXPECT_EQ(again[i].pose.x_m, trajectory[i].pose.x_m);
    EXPECT_EQ(again[i].pose.y_m, trajectory[i].pose.y_m);
    EXPECT_NEAR(wrap_angle(again[i].pose.theta_rad - trajectory[i].pose.theta_rad), 0.0, 1e-15);
  }
}

TEST(Tum, WritesTheShortestTextWithoutExponentAndTheHeadingAsAQuaternionAboutZ) {
  const TemporaryFolder folder;
  write_tum(folder / "path.tum", {{1211.520329, {-3.5, 0.000001, 0.0}}, {0.1, {1e6, 0, -kPi}}});
  EXPECT_THAT(bytes_of(folder / "path.tum"),
              testing::StartsWith("1211.520329 -3.5 0.000001 0 0 0 0 1\n0.1 1000000 0 0 0 0 -1 "));
  write_tum(folder / "empty.tum", {});
  EXPECT_EQ(bytes_of(folder / "empty.tum"), "");
}

TEST(Tum, ReadsCommentsAndNamesWhatIsWrong) {
  const TemporaryFolder folder;
  const Trajectory read = read_tum(
      folder.write("a.tum", "# timestamp tx ty tz qx qy qz qw\n1 2 3 0 0 0 0.7071068 0.7071068\n"));
  ASSERT_EQ(read.size(), 1U);
  EXPECT_NEAR(read[0].pose.theta_rad, kPi / 2, 1e-12);
  const auto of = [&](const std::string& text) {
    return refusal_by([&] { (void)read_tum(folder.write("b.tum", text)); });
  };
  EXPECT_THAT(of("\n1 2 3 0 0 0 0\n"), HasSubstr("b.tum:2: expected 8 numbers (timestamp tx ty"));
  EXPECT_THAT(of("1 2 3 0 0 0 0 0\n"), HasSubstr("b.tum:1: qx qy qz qw: expected a unit"));
  EXPECT_THAT(of("1 2 x 0 0 0 0 1\n"), HasSubstr("ty: expected a finite number, found 'x'"));
  EXPECT_THAT(of("1 nan 3 0 0 0 0 1\n"), HasSubstr("tx: expected a finite number, found 'nan'"));
  EXPECT_THAT(of(""), HasSubstr("b.tum: is empty"));
}

TEST(Relations, AreThePoseAtTheSecondTimeInTheFrameOfTheFirst) {
  const TemporaryFolder folder;
  const auto relations = read_relations(
      folder.write("a.relations",
                   "1216.630413 1217.490267 0.407950 -0.016330 0.0 0.0 0.0 -0.069620\n"
                   "\n5 4 1 2 9 9 9 7\n"));
  ASSERT_EQ(relations.size(), 2U);
  EXPECT_EQ(relations[0].t1_s, 1216.630413);
  EXPECT_EQ(relations[0].t2_s, 1217.490267);
  EXPECT_EQ(relations[0].pose1_from_pose2, (Pose2{0.40795, -0.01633, -0.06962}));
  EXPECT_NEAR(relations[1].pose1_from_pose2.theta_rad, 7 - 2 * kPi, 1e-12);
  EXPECT_THAT(refusal_by([&] {
                (void)read_relations(folder.write("b.relations", "1 2 3 4 5 6 7 8\n1 2 3\n"));
              }),
              HasSubstr("b.relations:2: expected 8 numbers (t1 t2 x y z roll pitch yaw), found 3"));
  EXPECT_THAT(refusal_by([&] { (void)read_relations(folder / "none"); }),
              HasSubstr("no such file"));
}

TEST(DriveFile, HoldsOneWayPointALineAndComments) {
  const TemporaryFolder folder;
  const Drive drive = read_drive(folder.write("drive.txt", "# tour\n1 2  # start\n\n-3.5 4e0\n"));
  EXPECT_THAT(drive, testing::ElementsAre(Point2(1, 2), Point2(-3.5, 4)));
  EXPECT_THAT(refusal_by([&] { (void)read_drive(folder.write("drive.txt", "1 2\n1 2 3\n")); }),
              HasSubstr("drive.txt:2: expected 2 numbers (x y), found 3"));
}

}  // namespace
}  // namespace roomatlas
