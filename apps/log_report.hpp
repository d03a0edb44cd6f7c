// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/mission/mission.hpp"

namespace roomatlas::apps {

/// A recording's topics with what they are used for, and its tree of frames, on stdout.
void print(const RecordingInfo& recording);

}  // namespace roomatlas::apps
