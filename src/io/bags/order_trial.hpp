// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/bag_source.hpp"

namespace roomatlas::io {

/// Of a laser without odometry, or one that sees all around: finds by the recording's beginning
/// whether its beams were measured in the order and time that its messages say, the other way round
/// (drivers of lasers that turn clockwise reverse the beams, and not their times), or at once for
/// all one can see: in the way that draws clearly sharper walls; else as told where there is
/// odometry, and at once where there is none. What was found is said in the choice's line.
void choose_beam_order(TopicChoice& choice, const Survey& beginning, const OpenRecording& open,
                       const MissionOptions& options, const std::string& file);

}  // namespace roomatlas::io
