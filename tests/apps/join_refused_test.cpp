// SPDX-License-Identifier: GPL-3.0-or-later
// What is not joined: single missions, the same one twice, stores that lack what it takes.
#include <gmock/gmock.h>

#include "joined_missions.hpp"

namespace roomatlas::test {
namespace {

using ::testing::HasSubstr;

TEST_F(Join, OfOneMissionAloneIsNotEnough) {
  const std::string store = copy_of_built("single") + "/missions/one.gpkg";
  const std::string joined = (*folder_ / "joined_single.gpkg").string();
  const Outcome outcome = run("-q join " + store + " -o " + joined);
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("joined are two missions and more"));
  EXPECT_FALSE(std::filesystem::exists(joined));
}

TEST_F(Join, OneMissionThatIsGivenTwiceIsOne) {
  const std::string place = (*folder_ / "repeated").string();
  const std::string store = place + "/building.gpkg";
  const std::string copy = (*folder_ / "copy.clf").string();
  std::filesystem::copy_file(one_, copy);
  const Outcome alone = run("build " + one_ + " " + copy + " -o " + place);
  EXPECT_EQ(alone.exit_code, 0) << alone.err;
  EXPECT_THAT(alone.err, HasSubstr("copy.gpkg: left out: "));
  const auto members = [&](const std::string& file) {
    return GeoPackageStore(file, GeoPackageStore::Mode::read).members().size();
  };
  EXPECT_EQ(members(store), 0U);
  const std::string joined = (*folder_ / "joined.gpkg").string();
  EXPECT_EQ(run("join " + store + " " + store + " -o " + joined).exit_code, 4);
  EXPECT_FALSE(std::filesystem::exists(joined));
  // of a mission and a building that has it the building stays, in any order
  const std::string both = copy_of_built("both");
  const Outcome known = run("join " + both + "/missions/one.gpkg " + both + "/building.gpkg " +
                            both + "/missions/two.gpkg -o " + joined);
  EXPECT_EQ(known.exit_code, 4);
  EXPECT_THAT(known.err,
              ::testing::AllOf(HasSubstr("one.gpkg: left out"), HasSubstr("two.gpkg: left out")));
}

TEST_F(Join, RefusesAStoreThatIsNotAssembled) {
  const std::string store = (*folder_ / "mapped.gpkg").string();
  ASSERT_EQ(run("-q map " + one_ + " -o " + store).exit_code, 0);
  const Outcome done =
      run("join " + store + " " + store + " -o " + (*folder_ / "none.gpkg").string());
  EXPECT_EQ(done.exit_code, 4);
  EXPECT_THAT(done.err, HasSubstr("mapped.gpkg: not assembled"));
}

TEST_F(Join, RefusesMissionsThatWereStoredWithoutReadings) {
  const std::string store = (*folder_ / "bare.gpkg").string();
  ASSERT_EQ(run("-q map --no-keep-readings " + one_ + " -o " + store).exit_code, 0);
  ASSERT_EQ(run("-q assemble " + store).exit_code, 0);
  for (const std::string& command :
       {"join " + store + " " + store + " -o " + (*folder_ / "none.gpkg").string(),
        "locate " + store + " " + one_}) {
    const Outcome done = run(command);
    EXPECT_EQ(done.exit_code, 4) << command;
    EXPECT_THAT(done.err, HasSubstr("bare.gpkg: was stored without its readings")) << command;
  }
  const std::filesystem::path out = *folder_ / "several";
  const Outcome several =
      run("build --no-keep-readings " + one_ + " " + two_ + " -o " + out.string());
  EXPECT_EQ(several.exit_code, 2);
  EXPECT_THAT(several.err, HasSubstr("--no-keep-readings"));
  EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace roomatlas::test
