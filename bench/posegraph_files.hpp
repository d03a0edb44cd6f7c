// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "recorded_data.hpp"

namespace roomatlas::bench {

/// All pose graphs of the recorded data, or none where there is no such folder.
inline std::vector<std::filesystem::path> pose_graph_files() {
  std::vector<std::filesystem::path> files;
  std::error_code missing;
  for (const auto& entry :
       std::filesystem::directory_iterator(recorded_data() / "posegraphs", missing)) {
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
