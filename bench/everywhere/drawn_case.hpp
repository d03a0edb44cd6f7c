// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "recorded_log.hpp"

namespace roomatlas::bench {

enum class Stratum { laser, sonar, hard, recorded };

[[nodiscard]] const char* to_string(Stratum stratum);

/// One mission: a building, a sensor and an odometry, as words for `roomatlas simulate`, or a
/// recorded log and what is done to it.
using Words = std::vector<std::string>;

struct DrawnCase {
  std::uint64_t seed = 0;  ///< of the run
  std::uint64_t number = 0;
  Stratum stratum = Stratum::laser;
  std::string building;             ///< kind of the world, or the map's name
  std::string sensor;               ///< "laser", "two lasers" or "sonar"
  std::vector<std::string> faults;  ///< what makes it hard, a word each
  bool has_rooms = true;            ///< the truth tells rooms
  std::string format = "clf";
  Words simulate;    ///< without -o; empty for a recorded log
  LogChange change;  ///< of a recorded log
  Words build;       ///< more flags of `roomatlas build`
};

/// Case `number` of the run `seed`; strata take turns, every tenth
/// case is a recorded log.
/// @param data folder of recorded data, whose maps and plans are drawn too
[[nodiscard]] DrawnCase drawn_case(std::uint64_t seed, std::uint64_t number,
                                   const std::filesystem::path& data);

}  // namespace roomatlas::bench
