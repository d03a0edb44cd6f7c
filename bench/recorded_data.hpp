// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <filesystem>

namespace roomatlas::bench {

/// The folder of recorded data: ROOMATLAS_DATA, or `../shared/data` beside the source tree.
inline std::filesystem::path recorded_data() {
  const char* folder = std::getenv("ROOMATLAS_DATA");
  return folder != nullptr ? std::filesystem::path(folder)
                           : std::filesystem::path(ROOMATLAS_SOURCE_DIR) / "../shared/data";
}

}  // namespace roomatlas::bench
