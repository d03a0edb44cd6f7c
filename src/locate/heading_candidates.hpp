// SPDX-License-Identifier: GPL-3.0-or-later
// How one map may be turned against another, by the directions of their walls.
#pragma once

#include <vector>

#include "roomatlas/match/scan.hpp"

namespace roomatlas {

/// How many walls look which way, in degrees: 360 values, smoothed. Zeros without walls.
[[nodiscard]] std::vector<double> direction_histogram(const std::vector<ScanPoint>& walls);

/// Turns of the second against the first that lay many walls' directions on each other, radians,
/// the best first. Where walls look all ways alike, turns in equal steps.
[[nodiscard]] std::vector<double> heading_candidates(const std::vector<double>& first,
                                                     const std::vector<double>& second);

}  // namespace roomatlas
