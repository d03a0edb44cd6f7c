// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/pose2.hpp"

#include <string>

namespace roomatlas::io {

/// `timestamp tx ty tz qx qy qz qw` a line.
[[nodiscard]] std::string tum_text(const Trajectory& trajectory);

}  // namespace roomatlas::io
