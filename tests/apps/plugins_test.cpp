// SPDX-License-Identifier: GPL-3.0-or-later
// What the program needs, and what it does where its plug-ins are not.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "random_store.hpp"

namespace roomatlas::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class WithoutPlugins : public ::testing::Test {
 protected:
  /// A copy of the program, far from where plug-ins are.
  void SetUp() override {
    std::filesystem::create_directories(folder_ / "bin");
    std::filesystem::copy_file(ROOMATLAS_PROGRAM, folder_ / "bin/roomatlas");
    store_ = assembled_store(folder_);
  }
  [[nodiscard]] Outcome run_alone(const std::string& arguments) const {
    return run_other((folder_ / "bin/roomatlas").string() + " " + arguments);
  }
  [[nodiscard]] Outcome export_alone(const std::string& options) const {
    return run_alone("export " + store_ + " " + options + " -o " + out_);
  }
  [[nodiscard]] std::set<std::string> written() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(out_)) {
      names.insert(entry.path().filename().string());
    }
    return names;
  }

  Folder folder_;
  std::string store_;
  std::string out_ = (folder_ / "out").string();
};

TEST_F(WithoutPlugins, AllElseIsExportedAndWhatIsNotIsSaid) {
  const Outcome outcome = export_alone("");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("no pdf, png: `apt-get install roomatlas-pictures`"));
  EXPECT_THAT(outcome.err, HasSubstr("no dxf: `apt-get install roomatlas-gdal`"));
  const std::set<std::string> names = written();
  for (const char* name : {"plan.svg", "plan.local.geojson", "map.pgm", "summary.json"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
  for (const char* name : {"plan.pdf", "plan.png", "plan.dxf"}) {
    EXPECT_FALSE(names.contains(name)) << name;
  }
}

TEST_F(WithoutPlugins, WhatIsAskedForByNameIsRefusedWithTheRemedy) {
  const auto refusal = [&](const std::string& options) {
    const Outcome outcome = export_alone(options);
    EXPECT_EQ(outcome.exit_code, 2) << options;
    return outcome.err;
  };
  EXPECT_THAT(refusal("-f png"), HasSubstr("PNG needs the plug-in roomatlas-pictures.so"));
  EXPECT_THAT(refusal("-f pdf"), HasSubstr("`apt-get install roomatlas-pictures`"));
  EXPECT_THAT(refusal("-f dxf"), HasSubstr("`apt-get install roomatlas-gdal`"));
  EXPECT_THAT(refusal("-f ogr --ogr GML"), HasSubstr("LD_LIBRARY_PATH"));
}

TEST_F(WithoutPlugins, ADamagedOneIsNotTakenForAMissingOne) {
  const std::filesystem::path plugin = folder_.write("roomatlas-gdal.so", "no library");
  const Outcome outcome =
      run_other("env LD_LIBRARY_PATH=" + plugin.parent_path().string() + " " +
                (folder_ / "bin/roomatlas").string() + " export " + store_ + " -f dxf -o " + out_);
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr(plugin.string()));
  EXPECT_THAT(outcome.err, HasSubstr("`apt-get install --reinstall roomatlas-gdal`"));
}

TEST_F(WithoutPlugins, TheDrawingIsTheSame) {
  ASSERT_EQ(export_alone("-f svg").exit_code, 0);
  const std::string with = (folder_ / "with").string();
  ASSERT_EQ(run("export " + store_ + " -f svg -o " + with).exit_code, 0);
  EXPECT_EQ(content_of(out_ + "/plan.svg"), content_of(with + "/plan.svg"));
}

TEST_F(WithoutPlugins, TheirFolderCanBeNamed) {
  const std::string plugins =
      (std::filesystem::path(ROOMATLAS_PROGRAM).parent_path() / "../lib/roomatlas").string();
  const Outcome outcome =
      run_other("env LD_LIBRARY_PATH=" + plugins + " " + (folder_ / "bin/roomatlas").string() +
                " export " + store_ + " -f png -o " + out_);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(written().contains("plan.png"));
}

TEST(Program, IsLinkedWithFewerThanFortyLibraries) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "sanitizers are libraries too";
#endif
  ROOMATLAS_NEEDS("ldd");
  const Outcome linked = run_other("ldd " ROOMATLAS_PROGRAM);
  ASSERT_EQ(linked.exit_code, 0) << linked.err;
  EXPECT_LT(std::count(linked.out.begin(), linked.out.end(), '\n'), 40) << linked.out;
  EXPECT_THAT(linked.out, Not(HasSubstr("libgdal")));
  EXPECT_THAT(linked.out, Not(HasSubstr("librsvg")));
}

}  // namespace
}  // namespace roomatlas::test
