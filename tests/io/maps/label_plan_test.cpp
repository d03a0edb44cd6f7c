// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/maps/label_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "roomatlas/core/issue.hpp"
#include "support/shared_data.hpp"
#include "support/temporary_folder.hpp"

namespace roomatlas {
namespace {

/// A picture as one reads it, top row first: digits are labels.
std::string labels_pgm(const std::vector<std::string>& rows, const std::string& comment = "") {
  std::string text = "P5\n" + comment + std::to_string(rows.front().size()) + " " +
                     std::to_string(rows.size()) + "\n255\n";
  for (const std::string& row : rows) {
    for (const char c : row) text += static_cast<char>(c == ' ' ? 0 : c - '0');
  }
  return text;
}

std::filesystem::path saved(const test::TemporaryFolder& folder, const std::string& content) {
  const auto file = folder.path() / "labels.pgm";
  std::ofstream(file, std::ios::binary) << content;
  return file;
}

TEST(LabelPlan, TracesRoomsAlongThePixelsEdges) {
  const test::TemporaryFolder folder;
  const auto file = saved(folder, labels_pgm({"       ",  //
                                              " 11 22 ",  //
                                              " 11  2 ",  //
                                              "       "},
                                             "# a comment\n"));
  const FloorPlan plan = read_label_plan(file, 0.5);
  ASSERT_EQ(plan.rooms.size(), 2U);
  EXPECT_EQ(plan.rooms[0].id, 1);
  EXPECT_THAT(plan.rooms[0].parts.at(0).outer,
              testing::UnorderedElementsAre(Point2(0.5, 0.5), Point2(1.5, 0.5), Point2(1.5, 1.5),
                                            Point2(0.5, 1.5)));
  EXPECT_DOUBLE_EQ(plan.rooms[0].area_m2, 1.0);
  EXPECT_EQ(plan.rooms[1].parts.at(0).outer.size(), 6U);
  EXPECT_DOUBLE_EQ(plan.rooms[1].area_m2, 0.75);
  EXPECT_GT(signed_area(plan.rooms[1].parts[0].outer), 0.0);
  EXPECT_TRUE(plan.doors.empty());
}

TEST(LabelPlan, KeepsHolesAndPartsOfARoom) {
  const test::TemporaryFolder folder;
  const FloorPlan plan = read_label_plan(saved(folder, labels_pgm({"1111 3",  //
                                                                   "1  1  ",  //
                                                                   "1 21  ",  //
                                                                   "1111 3"})),
                                         1.0);
  ASSERT_EQ(plan.rooms.size(), 3U);
  ASSERT_EQ(plan.rooms[0].parts.size(), 1U);
  EXPECT_EQ(plan.rooms[0].parts[0].holes.size(), 1U);
  EXPECT_DOUBLE_EQ(plan.rooms[0].area_m2, 12.0);
  EXPECT_DOUBLE_EQ(plan.rooms[1].area_m2, 1.0);
  EXPECT_EQ(plan.rooms[2].parts.size(), 2U);
  EXPECT_DOUBLE_EQ(plan.rooms[2].area_m2, 2.0);
}

TEST(LabelPlan, PixelsThatTouchAtACornerAreTwoParts) {
  const test::TemporaryFolder folder;
  const FloorPlan plan = read_label_plan(saved(folder, labels_pgm({"1 ", " 1"})), 1.0);
  EXPECT_EQ(plan.rooms.at(0).parts.size(), 2U);
}

TEST(LabelPlan, SaysWhatIsWrongWithAFile) {
  const test::TemporaryFolder folder;
  const auto refusal = [&](const std::string& content) -> std::string {
    try {
      (void)read_label_plan(saved(folder, content), 1.0);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(refusal("P7\n1 1\n255\n1"), testing::HasSubstr("expected"));
  EXPECT_THAT(refusal("P5\n2 x\n255\n"), testing::HasSubstr("height"));
  EXPECT_THAT(refusal("P5\n2 2\n255\n\1\1"), testing::HasSubstr("cut short"));
  EXPECT_THAT(refusal(labels_pgm({"  "})), testing::HasSubstr("holds no room"));
  EXPECT_THROW((void)read_label_plan(folder.path() / "none.pgm", 1.0), InputError);
  EXPECT_THROW((void)read_label_plan(saved(folder, labels_pgm({"1"})), 0.0), UsageError);
}

TEST(LabelPlan, ReadsTheRoomsOfFreiburg79) {
  const auto file = test::shared_data("rooms/Freiburg79_scan/Freiburg79_scan_gt_labels.pgm.gz");
  if (!file) return;
  const FloorPlan plan = read_label_plan(*file, 0.05);
  EXPECT_EQ(plan.rooms.size(), 18U);
  std::vector<double> areas;
  for (const PlanRoom& room : plan.rooms) areas.push_back(room.area_m2);
  std::sort(areas.rbegin(), areas.rend());
  EXPECT_NEAR(areas[0], 35.0, 0.5);
  EXPECT_NEAR(areas[1], 33.0, 0.5);
  EXPECT_NEAR(areas[2], 32.0, 0.5);
}

}  // namespace
}  // namespace roomatlas
