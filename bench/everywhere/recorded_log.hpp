// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "altered_odometry.hpp"

namespace roomatlas::bench {

/// What is done to a recorded log.
struct LogChange {
  std::string log;              ///< below the folder of recorded data; empty: none is altered
  std::size_t every_beam = 1;   ///< of the beams one in so many is left
  double view_deg = 360.0;      ///< beams farther from straight ahead than half of it are left out
  double max_range_m = 1000.0;  ///< farther returns are no echo
  double range_noise_m = 0.0;   ///< standard deviation
  OdometryChange odometry;
  int seed = 1;  ///< of the noise
};

/// Writes the readings of a log as another one (CARMEN), changed.
void write_changed_log(const std::filesystem::path& from, const LogChange& change,
                       const std::filesystem::path& to);

}  // namespace roomatlas::bench
