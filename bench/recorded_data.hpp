// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>

namespace roomatlas::bench {

/// The folder of recorded data: ROOMATLAS_DATA, or `../shared/data` beside the source tree.
inline std::filesystem::path recorded_data() {
  const char* folder = std::getenv("ROOMATLAS_DATA");
  return folder != nullptr ? std::filesystem::path(folder)
                           : std::filesystem::path(ROOMATLAS_SOURCE_DIR) / "../shared/data";
}

/// Whether a case is asked for by a part of its name; without any name all are.
inline bool is_wanted(const std::string& name, std::span<const char* const> parts) {
  return parts.empty() || std::any_of(parts.begin(), parts.end(), [&](const char* part) {
           return name.find(part) != std::string::npos;
         });
}

}  // namespace roomatlas::bench
