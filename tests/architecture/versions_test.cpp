// SPDX-License-Identifier: GPL-3.0-or-later
// What is said in several files of the project, for tools that do not read each other's.
#include <gmock/gmock.h>

#include <filesystem>
#include <regex>
#include <set>

#include "architecture/source_tree.hpp"

namespace roomatlas::architecture {
namespace {

/// All that the pattern's first group finds in a file of the project.
std::set<std::string> found_in(const std::string& file, const std::string& pattern) {
  const std::string text = read_text(std::filesystem::path(ROOMATLAS_SOURCE_DIR) / file);
  const std::regex regex(pattern);
  std::set<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at) {
    found.insert((*at)[1]);
  }
  return found;
}

TEST(Versions, AreTheSameForCMakePythonAndColcon) {
  const std::set<std::string> version =
      found_in("CMakeLists.txt", R"(project\(roomatlas VERSION ([\d.]+))");
  ASSERT_EQ(version.size(), 1U);
  EXPECT_EQ(found_in("pyproject.toml", "\nversion = \"([\\d.]+)\""), version);
  EXPECT_EQ(found_in("package.xml", R"(<version>([\d.]+)</version>)"), version);
}

TEST(Packages, ThatTheContainerAndTheTestInstallAreBuilt) {
  const std::set<std::string> built =
      found_in("cmake/package.cmake", R"(\n *roomatlas_deb\(\w+ ([\w-]+) )");
  EXPECT_EQ(built.size(), 6U);
  EXPECT_THAT(built, testing::IsSupersetOf(found_in("Dockerfile", R"(/packages/([\w-]+)_\*)")));
  EXPECT_EQ(found_in("packaging/test_in_bare_root.sh", R"(\$\(deb ([\w-]+)\))"), built);
  EXPECT_THAT(found_in("docs/packages.md", R"(\| `([\w-]+)` \|)"), testing::Eq(built));
}

}  // namespace
}  // namespace roomatlas::architecture
