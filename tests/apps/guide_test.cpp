// SPDX-License-Identifier: GPL-3.0-or-later
// The commands of docs/guide.md, run as they stand there, by a shell in an empty folder.
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "random_store.hpp"

namespace roomatlas::test {
namespace {

std::string guide() { return content_of(std::string(ROOMATLAS_SOURCE_DIR) + "/docs/guide.md"); }

std::vector<std::string> commands() {
  std::vector<std::string> found;
  std::istringstream lines(guide());
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("    roomatlas ")) found.push_back(line.substr(4));
  }
  return found;
}

/// The files of output folders that the text speaks of: `plan/plan.pdf`.
std::vector<std::string> files() {
  const std::string text = guide();
  const std::regex name(R"re(`((?:drive|plan|changes|cad|nav2)2?/[a-z_.]+)`)re");
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), name), end; at != end; ++at) {
    found.push_back((*at)[1]);
  }
  return found;
}

TEST(Guide, EachCommandWorksAndLeavesTheFilesThatTheTextNames) {
  const Folder folder;
  const std::string program = ROOMATLAS_PROGRAM;
  const std::string path = program.substr(0, program.rfind('/'));
  ASSERT_GT(commands().size(), 8U);
  for (const std::string& command : commands()) {
    const Outcome outcome =
        run_other("(cd " + (folder / "").string() + " && PATH=" + path + ":$PATH " + command + ")");
    ASSERT_EQ(outcome.exit_code, 0) << command << "\n" << outcome.out << outcome.err;
  }
  ASSERT_GT(files().size(), 4U);
  for (const std::string& file : files()) {
    EXPECT_GT(content_of(folder / file).size(), 0U) << file;
  }
}

}  // namespace
}  // namespace roomatlas::test
