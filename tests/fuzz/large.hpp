// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs of about a megabyte in which all is as far from a building as it can be: no mutation makes
// them, and each once took a reader minutes or gigabytes, or might.
#pragma once

#include <string>
#include <vector>

namespace roomatlas::fuzz {

/// GeoJSON: strips across strips, rooms on one place, an outline of 100,000 crossing chords, holes.
[[nodiscard]] std::vector<std::string> large_worlds();
/// PGM: noise, the teeth of a comb, a number of its own for each pixel.
[[nodiscard]] std::vector<std::string> large_pictures();
/// CARMEN: a sensor of its own in each line, sweeps of 80,000 beams, unknown tags.
[[nodiscard]] std::vector<std::string> large_logs();

}  // namespace roomatlas::fuzz
