// SPDX-License-Identifier: GPL-3.0-or-later
// Corrections by hand, as a user makes them: kept, replayed, and said where they no longer fit.
#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>

#include <algorithm>

#include "edited_store.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"

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

TEST_F(Edits, OfAnotherFileTakeThoseOfBeforeBackWhichIsSaid) {
  const std::string kind = R"({"edit":"set_room_kind","room":{"id":1},"kind":"hall"})";
  const std::string name = R"({"edit":"name_room","room":{"id":1},"name":"Kitchen"})";
  const std::string both = edits_file(folder_, kind + "," + name);
  ASSERT_EQ(run("-q assemble " + store() + " --edits " + both).exit_code, 0);
  EXPECT_THAT(run("assemble " + store() + " --edits " + both).err, Not(HasSubstr("taken back")));
  const std::string one = edits_file(folder_, name);
  EXPECT_THAT(run("assemble " + store() + " --edits " + one).err,
              HasSubstr("edits.json: 1 correction that the store kept is not in it and is taken"));
}

TEST_F(Edits, OfARoomThatTheyReshapeAreTheSameWhenTheyAreToldAgain) {
  const std::string edits = edits_file(
      folder_, R"({"edit":"split_room","room":{"id":2},"line_m":[[5.5,-2.2],[5.5,3.5]]})");
  const std::string command = "assemble " + store() + " --edits " + edits;
  ASSERT_EQ(run("-q " + command).exit_code, 0);
  EXPECT_THAT(run(command).err, Not(HasSubstr("taken back")));
}

TEST_F(Edits, TakeThePlaceOfThoseThatCannotBeRead) {
  ASSERT_EQ(run("-q rename " + store() + " 1 Kitchen").exit_code, 0);
  SQLite::Database(store(), SQLite::OPEN_READWRITE)
      .exec(R"(UPDATE metadata SET value = '{"edits": 3}' WHERE key = 'edits_json')");
  EXPECT_EQ(run("-q assemble " + store()).exit_code, 3);
  const std::string edits =
      edits_file(folder_, R"({"edit":"name_room","room":{"id":1},"name":"Pantry"})");
  const Outcome assembled = run("assemble " + store() + " --edits " + edits);
  EXPECT_EQ(assembled.exit_code, 0);
  EXPECT_THAT(assembled.err, HasSubstr("edits_json"));
  EXPECT_THAT(assembled.err, HasSubstr("edits.json hold in their place"));
  EXPECT_THAT(plan(), HasSubstr("Pantry"));
}

TEST_F(Edits, NamesThatNoStatementGivesComeBackWithTheirRoom) {
  const auto rooms = [&] {
    return GeoPackageStore(store(), GeoPackageStore::Mode::read).plan().rooms;
  };
  ASSERT_EQ(run("-q rename " + store() + " 1 Kitchen").exit_code, 0);
  ASSERT_EQ(run("-q rename " + store() + " 2 Pantry").exit_code, 0);
  const std::string none = edits_file(folder_, "");
  ASSERT_EQ(run("-q assemble " + store() + " --edits " + none).exit_code, 0);
  const std::vector<PlanRoom> before = rooms();
  ASSERT_EQ(before.size(), 2U);
  const auto [small, large] = std::minmax(before[0].area_m2, before[1].area_m2);
  const Outcome without =
      run("assemble " + store() + " --min-room " + std::to_string((small + large) / 2.0));
  EXPECT_EQ(without.exit_code, 0);
  EXPECT_THAT(without.err, HasSubstr("was not found again: its name is kept until it is"));
  ASSERT_EQ(rooms().size(), 1U);
  const std::string there = std::to_string(rooms()[0].id);
  ASSERT_EQ(run("-q rename " + store() + " " + there + " Office").exit_code, 0);
  ASSERT_EQ(run("-q assemble " + store() + " --min-room 0.5").exit_code, 0);
  ASSERT_EQ(rooms().size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const bool was_there = std::to_string(before[i].id) == there;
    EXPECT_EQ(rooms()[i].name, was_there ? "Office" : before[i].name);
  }
}

}  // namespace
}  // namespace roomatlas::test
