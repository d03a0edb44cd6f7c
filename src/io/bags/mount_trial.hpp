// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/bag_source.hpp"

namespace roomatlas::io {

/// Where no tf joins the laser and the robot: finds the mount by how sweeps and odometry move
/// against each other in the recording's beginning, and sets it where it is sure; says so in the
/// choice's line and in a warning. Else nothing is done, and reading will refuse.
void find_mount(TopicChoice& choice, const Survey& beginning, const OpenRecording& open,
                const MissionOptions& options, const std::string& file);

}  // namespace roomatlas::io
