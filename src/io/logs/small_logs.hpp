// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/mission/mission.hpp"

#include <filesystem>
#include <memory>

namespace roomatlas::io {

// Logs of formats that one laboratory used each (docs/formats.md has their fields).

/// The log of Carnegie Mellon's Wean Hall that S. Thrun gave out: `O` and `L` lines, centimetres.
[[nodiscard]] std::unique_ptr<MissionSource> open_wean_log(const std::filesystem::path& file,
                                                           const MissionOptions& options);

/// DP-SLAM's logs (Duke University): `Odometry` and `Laser` lines in turn, metres, no times.
[[nodiscard]] std::unique_ptr<MissionSource> open_duke_log(const std::filesystem::path& file,
                                                           const MissionOptions& options);

/// tinySLAM's logs (Mines ParisTech): a scan a line, wheel encoders in ticks, no tags.
[[nodiscard]] std::unique_ptr<MissionSource> open_mines_log(const std::filesystem::path& file,
                                                            const MissionOptions& options);

/// Which of these a file holds, by its first line that is no comment; null for none of them.
using OpenLog = std::unique_ptr<MissionSource> (*)(const std::filesystem::path&,
                                                   const MissionOptions&);
[[nodiscard]] OpenLog find_small_log(const std::filesystem::path& file);

}  // namespace roomatlas::io
