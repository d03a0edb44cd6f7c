// SPDX-License-Identifier: GPL-3.0-or-later
// An assembled store in a few seconds, without driving through a world.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>

#include "program.hpp"

namespace roomatlas::test {

/// Makes `building.gpkg` of a random building in the folder and assembles it.
inline std::string assembled_store(const Folder& folder) {
  const std::string place = (folder / "random").string();
  const Outcome made = run("-q simulate --random-rooms 12 -o " + place);
  EXPECT_EQ(made.exit_code, 0) << made.err;
  const std::string store = place + "/building.gpkg";
  const Outcome assembled = run("-q assemble " + store);
  EXPECT_EQ(assembled.exit_code, 0) << assembled.err;
  return store;
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
