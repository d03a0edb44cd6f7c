// SPDX-License-Identifier: GPL-3.0-or-later
#include "carmen_source.hpp"
#include "small_logs.hpp"

#include "roomatlas/io/formats.hpp"

#include <system_error>

namespace roomatlas {

std::unique_ptr<MissionSource> open_mission(const Path& file, const MissionOptions& options) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(file, ignored)) {  // a pipe can be read once only
    if (const io::OpenLog open = io::find_small_log(file)) return open(file, options);
  }
  return std::make_unique<io::CarmenSource>(file, options);
}

}  // namespace roomatlas
