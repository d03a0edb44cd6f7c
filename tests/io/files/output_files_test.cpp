// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/temporary_folder.hpp"

#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/files/files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomatlas {
namespace {

using test::bytes_of;
using test::TemporaryFolder;
using ::testing::HasSubstr;

TEST(WriteFile, ReplacesTheFileAndLeavesNothingElse) {
  const TemporaryFolder folder;
  folder.write("plan.svg", "old");
  write_file(folder / "plan.svg", std::string("new\0content", 11));
  EXPECT_EQ(bytes_of(folder / "plan.svg"), std::string("new\0content", 11));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(WriteFile, SaysWhyItFailsAndLeavesTheOldFileAlone) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "taken");
  for (const Path& file : {folder / "missing/plan.svg", folder / "taken"}) {
    try {
      write_file(file, "new");
      FAIL() << file;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(file.string() + ": cannot be written: "));
    }
  }
  EXPECT_TRUE(std::filesystem::is_directory(folder / "taken"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(Sha256, OfAFileIsTheStandardsTestVector) {
  const TemporaryFolder folder;
  EXPECT_EQ(sha256_of_file(folder.write("abc", "abc")),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of_file(folder.write("empty", "")),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_of_file(folder.write("million", std::string(1'000'000, 'a'))),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
  EXPECT_THROW((void)sha256_of_file(folder / "none"), InputError);
  EXPECT_THROW((void)sha256_of_file(folder.path()), InputError);
}

}  // namespace
}  // namespace roomatlas
