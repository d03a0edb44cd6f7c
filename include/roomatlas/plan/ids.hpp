// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace roomatlas {

using AsrId = std::int64_t;   ///< 1, 2, 3 ... in the order in which the robot entered
using RoomId = std::int64_t;  ///< 1, 2, 3 ...; 0 = not decided yet
using DoorId = std::int64_t;  ///< 1, 2, 3 ... as the plan lists them

}  // namespace roomatlas
