// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "roomatlas/mission/mission.hpp"

namespace roomatlas::apps {

/// The log's mission as it is mapped; one of a recording without odometry by scan matching alone.
/// @throws InputError for what is no log
[[nodiscard]] std::unique_ptr<MissionSource> open_log(const std::filesystem::path& log,
                                                      const MissionOptions& options);

}  // namespace roomatlas::apps
