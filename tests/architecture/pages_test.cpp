// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>

#include "architecture/source_tree.hpp"

namespace roomatlas::architecture {
namespace {

namespace fs = std::filesystem;

/// The files that a page names: `place/name.cpp`, and .hpp.
std::vector<std::string> files_named_in(const std::string& page) {
  static const std::regex file("`((?:[A-Za-z0-9_]+/)+[A-Za-z0-9_]+\\.(?:cpp|hpp))`");
  std::vector<std::string> names;
  for (std::sregex_iterator it(page.begin(), page.end(), file), end; it != end; ++it) {
    names.push_back((*it)[1]);
  }
  return names;
}

/// Pages leave `src/` and `include/roomatlas/` out where that is clear.
bool exists_in_the_project(const std::string& name) {
  const std::vector<std::string> below = {"", "src/", "include/roomatlas/", "include/"};
  return std::any_of(below.begin(), below.end(), [&](const std::string& folder) {
    return fs::exists(fs::path(ROOMATLAS_SOURCE_DIR) / (folder + name));
  });
}

TEST(Pages, NameNoFileThatIsNotThere) {
  const fs::path root = ROOMATLAS_SOURCE_DIR;
  std::vector<fs::path> pages = {root / "README.md"};
  for (const auto& entry : fs::directory_iterator(root / "docs")) {
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  }
  std::size_t names = 0;
  for (const fs::path& page : pages) {
    for (const std::string& name : files_named_in(read_text(page))) {
      EXPECT_TRUE(exists_in_the_project(name)) << page.filename() << " names " << name;
      ++names;
    }
  }
  EXPECT_GT(names, 100U);
}

TEST(Pages, CheckSeesAFileThatIsNotThere) {
  EXPECT_EQ(files_named_in("see `core/pose2.hpp` and `a.cpp`").size(), 1U);
  EXPECT_TRUE(exists_in_the_project("core/pose2.hpp"));
  EXPECT_FALSE(exists_in_the_project("core/pose3.hpp"));
}

}  // namespace
}  // namespace roomatlas::architecture
