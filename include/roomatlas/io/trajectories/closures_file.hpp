// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "roomatlas/loops/closures.hpp"

namespace roomatlas {

/// Measurements to be tried beside those that are found, one `from_asr to_asr x_m y_m theta_rad` a
/// line: the frame of the second ASR in that of the first. Empty lines and what follows `#` are
/// skipped. Throws InputError naming file, line and field.
[[nodiscard]] std::vector<GivenClosure> read_closures(const std::filesystem::path& file);

}  // namespace roomatlas
