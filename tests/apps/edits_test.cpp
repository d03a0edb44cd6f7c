// SPDX-License-Identifier: GPL-3.0-or-later
// Corrections by hand, as a user makes them: kept, replayed, and said where they no longer fit.
#include <gmock/gmock.h>

#include "edited_store.hpp"

namespace roomatlas::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST_F(Edits, AreReplayedAfterMappingAgainToTheSameBytes) {
  const std::string plain = plan();
  const std::string edits = edits_file(folder_, R"(
    {"edit":"name_room","room":{"id":1},"name":"Kitchen"},
    {"edit":"set_room_kind","room":{"id":1},"kind":"hall"},
    {"edit":"split_room","room":{"id":2},"line_m":[[5.5,-2.2],[5.5,3.5]]},
    {"edit":"move_wall","wall_m":[[2.4,-2.0],[2.4,2.0]],"by_m":-0.1},
    {"edit":"shut_door","at_m":[2.4,-0.15]},
    {"edit":"add_door","jambs_m":[[2.5,0.8],[2.5,1.6]]})");
  const Outcome assembled = run("assemble " + store() + " --edits " + edits);
  ASSERT_EQ(assembled.exit_code, 0) << assembled.err;
  EXPECT_THAT(assembled.err, Not(HasSubstr("no longer fits")));
  const std::string edited = plan();
  EXPECT_NE(edited, plain);
  EXPECT_THAT(edited, HasSubstr("Kitchen"));
  ASSERT_EQ(run("-q assemble " + store()).exit_code, 0) << "kept in the store";
  EXPECT_EQ(plan(), edited);
  ASSERT_EQ(run("-q map " + log() + " -o " + store()).exit_code, 0);
  ASSERT_EQ(run("-q assemble " + store()).exit_code, 0);
  EXPECT_EQ(plan(), edited);
}

TEST_F(Edits, ThatNoLongerFitAreSaidAndNotApplied) {
  const std::string plain = plan();
  const std::string edits = edits_file(folder_, R"({"edit":"shut_door","at_m":[900.0,0.0]})");
  const Outcome assembled = run("assemble " + store() + " --edits " + edits);
  EXPECT_EQ(assembled.exit_code, 0);
  EXPECT_THAT(assembled.err, HasSubstr("edits[0] shut_door: no longer fits and is not applied: no "
                                       "door or opening is near (900.00, 0.00)"));
  EXPECT_EQ(plan(), plain);
}

TEST_F(Edits, ThatCannotBeReadLeaveTheStoreAsItWas) {
  const std::string bytes = content_of(store());
  const std::string edits = edits_file(folder_, R"({"edit":"shut_door"})");
  const Outcome refused = run("assemble " + store() + " --edits " + edits);
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_THAT(refused.err, HasSubstr("edits.json: edits[0].at_m: missing"));
  EXPECT_TRUE(content_of(store()) == bytes) << "the store was changed";
}

TEST_F(Edits, RenameWritesTheSameStatement) {
  ASSERT_EQ(run("-q rename " + store() + " 1 Kitchen").exit_code, 0);
  const std::string renamed = plan();
  ASSERT_EQ(run("-q assemble " + store()).exit_code, 0);
  EXPECT_EQ(plan(), renamed);
  const std::string other = (folder_ / "other.gpkg").string();
  std::filesystem::copy_file(*shared_ / "b.gpkg", other);
  const std::string edits =
      edits_file(folder_, R"({"edit":"name_room","room":{"id":1},"name":"Kitchen"})");
  ASSERT_EQ(run("-q assemble " + other + " --edits " + edits).exit_code, 0);
  std::filesystem::rename(other, store());
  EXPECT_EQ(plan(), renamed);
}

}  // namespace
}  // namespace roomatlas::test
