// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "roomatlas/mission/mission.hpp"

namespace roomatlas {

/// The same mission, whose info warns of a clock that no mission has: one that goes back by more
/// than a second from one reading to the next, or by which they are a minute apart in the mean, as
/// times in milliseconds are. Readings are taken in the order of the log; times tell which true
/// pose, and which line of another file, is a reading's.
[[nodiscard]] std::unique_ptr<MissionSource> with_clock_watched(
    std::unique_ptr<MissionSource> mission);

}  // namespace roomatlas
