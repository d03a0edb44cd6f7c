// SPDX-License-Identifier: GPL-3.0-or-later
// Which store a mission of several has, where its log's name alone does not say it.
#include <gmock/gmock.h>

#include "joined_missions.hpp"
#include "roomatlas/io/files/files.hpp"

namespace roomatlas::test {
namespace {

namespace fs = std::filesystem;

/// Two missions whose logs are called run.clf, built into `out`.
class MissionStores : public Join {
 protected:
  void SetUp() override {
    for (const auto& [name, log] : {std::pair("a", one_), std::pair("b", two_)}) {
      fs::create_directory(own_ / name);
      fs::copy_file(log, own_ / name / "run.clf");
    }
    a_ = (own_ / "a/run.clf").string();
    b_ = (own_ / "b/run.clf").string();
    fs::create_directories(missions_);
  }
  [[nodiscard]] Outcome build(const std::string& logs) const {
    return run("-q build " + logs + " -o " + (own_ / "out").string());
  }
  /// The digest of the log that a store was mapped from.
  [[nodiscard]] std::string mission_in(const std::string& store) const {
    return GeoPackageStore(missions_ / store, GeoPackageStore::Mode::read)
        .metadata()
        .at("mission_sha256");
  }

  Folder own_;
  fs::path missions_ = own_ / "out/missions";
  std::string a_;
  std::string b_;
};

TEST_F(MissionStores, AnUnfinishedOneIsThatOfItsLog) {
  {
    GeoPackageStore store(missions_ / "run.gpkg", GeoPackageStore::Mode::create);
    store.put_origin({{"mission_sha256", sha256_of_file(b_)}, {"tool_version", "0"}});
    Asr asr;
    asr.id = 1;
    store.put(asr, "of another version");
  }
  const Outcome done = build(a_ + " " + b_);
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(mission_in("run.gpkg"), sha256_of_file(b_));
  EXPECT_EQ(mission_in("run-2.gpkg"), sha256_of_file(a_));
}

TEST_F(MissionStores, TwoNamesOfOneFileAreOneStore) {
  fs::create_symlink("run.gpkg", missions_ / "run-2.gpkg");
  const Outcome done = build(a_ + " " + b_);
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(mission_in("run-2.gpkg"), sha256_of_file(a_));
  EXPECT_EQ(mission_in("run-3.gpkg"), sha256_of_file(b_));
  ASSERT_EQ(build(b_ + " " + a_).exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(missions_ / "run-2.gpkg"));
  EXPECT_EQ(mission_in("run.gpkg"), sha256_of_file(a_));
  EXPECT_EQ(mission_in("run-3.gpkg"), sha256_of_file(b_));
}

TEST_F(MissionStores, ALogThatIsGivenTwiceKeepsBoth) {
  ASSERT_EQ(build(a_ + " " + b_ + " " + a_).exit_code, 0);
  const auto first = files_in(missions_);
  EXPECT_EQ(first.size(), 3U);
  ASSERT_EQ(build(b_ + " " + a_ + " " + a_).exit_code, 0);
  EXPECT_TRUE(files_in(missions_) == first);
  ASSERT_EQ(build(b_ + " " + a_).exit_code, 0);
  EXPECT_TRUE(files_in(missions_) == first);
}

TEST_F(MissionStores, AnotherNameTakesNoneThatHasItsLog) {
  const std::string numbered = (own_ / "run-2.clf").string();
  fs::copy_file(one_, numbered);
  ASSERT_EQ(build(numbered + " " + two_).exit_code, 0);
  const std::string bytes = content_of(missions_ / "run-2.gpkg");
  ASSERT_GT(bytes.size(), 10000U);
  fs::copy_file(two_, a_, fs::copy_options::overwrite_existing);
  ASSERT_EQ(build(a_ + " " + b_ + " " + numbered).exit_code, 0);
  EXPECT_TRUE(content_of(missions_ / "run-2.gpkg") == bytes);
}

}  // namespace
}  // namespace roomatlas::test
