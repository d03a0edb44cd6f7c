// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/plan/floor_plan.hpp"

#include <filesystem>

namespace roomatlas {

/// Reads a label picture: a binary PGM (plain or gzip) whose grey value is the number of the room
/// that the pixel lies in, 0 for none. The rooms are traced along the pixels' edges; their ids are
/// the labels. The frame's origin is the picture's lower left corner, x to the right, y up. Such a
/// truth knows no doors and no walls. Throws InputError naming the file when it cannot be read or
/// holds no room, UsageError when the pixel size is not positive.
[[nodiscard]] FloorPlan read_label_plan(const std::filesystem::path& file, double pixel_m);

}  // namespace roomatlas
