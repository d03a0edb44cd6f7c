// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "roomatlas/mission/mission.hpp"

namespace roomatlas {

/// The mission with one kind of sensor: its lasers where one is among the first 200 range readings,
/// else its sonars. A laser's poses come from matching each reading, those of sonars from the whole
/// mission; readings of both kinds could have neither. The readings of the other kind are left out,
/// counted, and told of in a warning.
[[nodiscard]] std::unique_ptr<MissionSource> one_sensor_kind(
    std::unique_ptr<MissionSource> mission);

}  // namespace roomatlas
