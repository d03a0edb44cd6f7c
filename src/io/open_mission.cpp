// SPDX-License-Identifier: GPL-3.0-or-later
#include "carmen_source.hpp"

#include "roomatlas/io/formats.hpp"

namespace roomatlas {

std::unique_ptr<MissionSource> open_mission(const Path& file, const MissionOptions& options) {
  return std::make_unique<io::CarmenSource>(file, options);
}

}  // namespace roomatlas
