// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/pose2.hpp"
#include "roomatlas/io/files/path.hpp"

namespace roomatlas {

/// TUM trajectory: `timestamp tx ty tz qx qy qz qw` a line, numbers in their shortest form that
/// reads back to the same double.
void write_tum(const Path& file, const Trajectory& trajectory);
[[nodiscard]] Trajectory read_tum(const Path& file);

}  // namespace roomatlas
