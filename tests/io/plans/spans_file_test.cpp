// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/plans/spans_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomatlas/core/issue.hpp"
#include "support/temporary_folder.hpp"

namespace roomatlas {
namespace {

TEST(SpansFile, ReadsDoorsWallsAndPoints) {
  const test::TemporaryFolder folder;
  const auto spans = read_spans(folder.write("tape.csv",
                                             "# a comment\n"
                                             "width of 3, room 3 west, room 3 east, 4.02\n"
                                             "\n"
                                             "doors,door 1,door 12,7.5 # measured twice\n"
                                             "corner to door, 1.5 -2, door 4, 3\n"));
  ASSERT_EQ(spans.size(), 3U);
  EXPECT_EQ(spans[0].name, "width of 3");
  EXPECT_EQ(std::get<WallEnd>(spans[0].from).room, 3);
  EXPECT_EQ(std::get<WallEnd>(spans[0].from).side, Side::west);
  EXPECT_EQ(std::get<WallEnd>(spans[0].to).side, Side::east);
  EXPECT_DOUBLE_EQ(spans[0].true_m, 4.02);
  EXPECT_EQ(std::get<DoorEnd>(spans[1].to).door, 12);
  EXPECT_EQ(std::get<PointEnd>(spans[2].from).point, Point2(1.5, -2));
}

TEST(SpansFile, NamesLineAndFieldAtFault) {
  const test::TemporaryFolder folder;
  const auto refusal = [&](const std::string& line) -> std::string {
    try {
      (void)read_spans(folder.write("tape.csv", "a, door 1, door 2, 3\n" + line + "\n"));
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(refusal("a, door 1, door 2"), testing::HasSubstr("tape.csv:2: expected four fields"));
  EXPECT_THAT(refusal("a, door 1, door 2, 3, 4"), testing::HasSubstr("four fields"));
  EXPECT_THAT(refusal("a, door x, door 2, 3"), testing::HasSubstr("from: expected"));
  EXPECT_THAT(refusal("a, door 1, room 2 up, 3"), testing::HasSubstr("to: expected"));
  EXPECT_THAT(refusal("a, door 1, door 2, -3"), testing::HasSubstr("metres: expected"));
  EXPECT_THROW((void)read_spans(folder.write("empty.csv", "# nothing\n")), InputError);
}

}  // namespace
}  // namespace roomatlas
