// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the real program, as a user would.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "support/temporary_folder.hpp"

namespace roomatlas::test {

inline std::string content_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The content of each file in a folder and below it, by its path from there.
inline std::map<std::string, std::string> files_in(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files[entry.path().lexically_relative(folder).string()] = content_of(entry.path());
    }
  }
  return files;
}

inline const std::string kTwoRooms =
    std::string(ROOMATLAS_SOURCE_DIR) + "/data/worlds/two_rooms.geojson";

using Folder = TemporaryFolder;

struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string err;
};

inline Outcome run(const std::string& arguments) {
  const Folder folder;
  const std::string command = std::string(ROOMATLAS_PROGRAM) + " " + arguments + " >" +
                              (folder / "out").string() + " 2>" + (folder / "err").string();
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(folder / "out"),
          content_of(folder / "err")};
}

}  // namespace roomatlas::test
