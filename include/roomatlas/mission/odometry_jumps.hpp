// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "roomatlas/mission/mission.hpp"

namespace roomatlas {

/// The mission without jumps of odometry: a step between two readings that no robot drives (over
/// 10 m and 20 m for each second) is taken for none. Odometry that was set to another place in the
/// middle of a mission goes on from where it was. Jumps are counted, and told of in a warning;
/// headings are as the log has them.
[[nodiscard]] std::unique_ptr<MissionSource> without_odometry_jumps(
    std::unique_ptr<MissionSource> mission);

}  // namespace roomatlas
