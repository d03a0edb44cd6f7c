// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/bag_source.hpp"

namespace roomatlas::io {

/// Of the gyros that may be taken, takes the one whose turns are clearly nearer to those of matched
/// sweeps than odometry's are, over a recording's beginning with turns; else none. Missing odometry
/// is one that never turns. One that the options name is taken whatever is found. What was found is
/// said in the choice's line.
void choose_gyro(TopicChoice& choice, const Survey& beginning, const OpenRecording& open,
                 const MissionOptions& options, const std::string& file);

}  // namespace roomatlas::io
