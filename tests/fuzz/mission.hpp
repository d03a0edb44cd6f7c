// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/io/files/path.hpp"
#include "roomatlas/mission/mission.hpp"

namespace roomatlas::fuzz {

/// A second of a simulated robot in a shipped world, in the format of the file's name.
void write_mission(const Path& file, SensorKind kind);

/// Takes all events, and asks for what was found out.
void read_whole(MissionSource& mission);

}  // namespace roomatlas::fuzz
