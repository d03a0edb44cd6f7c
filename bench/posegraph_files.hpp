// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace roomatlas::bench {

/// All pose graphs of the recorded data, or none where there is no such folder. ROOMATLAS_DATA, or
/// `../shared/data` beside the source tree.
inline std::vector<std::filesystem::path> pose_graph_files() {
  const char* folder = std::getenv("ROOMATLAS_DATA");
  const std::filesystem::path data =
      folder != nullptr ? std::filesystem::path(folder)
                        : std::filesystem::path(ROOMATLAS_SOURCE_DIR) / "../shared/data";
  std::vector<std::filesystem::path> files;
  std::error_code missing;
  for (const auto& entry : std::filesystem::directory_iterator(data / "posegraphs", missing)) {
    const std::string name = entry.path().filename().string();
    const bool graph = name.ends_with(".g2o.gz") || name.ends_with(".graph.gz");
    if (graph && name.find("groundtruth") == std::string::npos) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

inline std::string short_name(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  return name.substr(0, name.find('.'));
}

}  // namespace roomatlas::bench
