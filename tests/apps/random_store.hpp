// SPDX-License-Identifier: GPL-3.0-or-later
// An assembled store in a few seconds, without driving through a world.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>

#include "program.hpp"

namespace roomatlas::test {

/// A random building with its truth, made and assembled once in a process: for copies.
inline const std::filesystem::path& random_building() {
  static const Folder folder;
  static const std::filesystem::path place = [] {
    const std::string made = (folder / "random").string();
    const Outcome simulated = run("-q simulate --random-rooms 12 -o " + made);
    EXPECT_EQ(simulated.exit_code, 0) << simulated.err;
    const Outcome assembled = run("-q assemble " + made + "/building.gpkg");
    EXPECT_EQ(assembled.exit_code, 0) << assembled.err;
    return made;
  }();
  return place;
}

/// Puts `random/building.gpkg`, an assembled random building, into the folder.
inline std::string assembled_store(const Folder& folder) {
  const std::filesystem::path place = folder / "random";
  std::filesystem::copy(random_building(), place, std::filesystem::copy_options::recursive);
  return (place / "building.gpkg").string();
}

/// Runs another program; its exit code and what it prints.
inline Outcome run_other(const std::string& command) {
  const Folder folder;
  const std::string whole =
      command + " >" + (folder / "out").string() + " 2>" + (folder / "err").string();
  const int status = std::system(whole.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(folder / "out"),
          content_of(folder / "err")};
}

inline bool is_installed(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

}  // namespace roomatlas::test

/// Skips where a program is missing; on the build server that is a failure.
#define ROOMATLAS_NEEDS(program)                                                     \
  if (!::roomatlas::test::is_installed(program)) {                                   \
    const char* ci = std::getenv("CI");                                              \
    if (ci != nullptr && std::string(ci) == "true") FAIL() << program " is missing"; \
    GTEST_SKIP() << program " is missing";                                           \
  }
