// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace roomatlas::test {

/// The folder of recorded data: environment variable ROOMATLAS_DATA, else `../shared/data` beside
/// the source tree.
inline std::filesystem::path shared_data_folder() {
  if (const char* folder = std::getenv("ROOMATLAS_DATA")) return folder;
  return std::filesystem::path(ROOMATLAS_SOURCE_DIR) / "../shared/data";
}

/// A recorded file, by its name below the data folder. Where it is missing the test is marked as
/// skipped, or as failed where CI=true, and nothing is returned: the test then has to return.
inline std::optional<std::filesystem::path> shared_data(const std::string& name) {
  const std::filesystem::path file = shared_data_folder() / name;
  if (std::filesystem::exists(file)) return file;
  const char* ci = std::getenv("CI");
  const bool must_exist = ci != nullptr && std::string(ci) == "true";
  const std::string message = "recorded data is missing: " + file.string() +
                              "; set ROOMATLAS_DATA to the folder that holds it";
  if (must_exist) {
    ADD_FAILURE() << message;
  } else {
    [&] { GTEST_SKIP() << message; }();
  }
  return std::nullopt;
}

}  // namespace roomatlas::test
