// SPDX-License-Identifier: GPL-3.0-or-later
// What became of each query, and what is learnt from it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "roomatlas/core/learnt_sum.hpp"
#include "roomatlas/mission/mission.hpp"

namespace roomatlas::bench {

struct PlaceSample {
  std::string asked;  ///< the building and the log; left out together when something is learnt
  SensorKind sensor = SensorKind::laser;
  bool is_known = true;  ///< the building has seen most of the floor that the piece runs over
  bool is_right = false;
  double probability = 0.0;           ///< that was given to the likeliest place
  std::vector<JudgedFigure> figures;  ///< empty where no place was found
};

/// One JSON object, on a line.
[[nodiscard]] std::string line_of(const PlaceSample& sample);
/// @throws std::runtime_error where a file cannot be read
[[nodiscard]] std::vector<PlaceSample> read_place_samples(
    const std::vector<std::filesystem::path>& files);

/// src/join/laser_places.cpp or sonar_places.cpp: log odds that the likeliest place is right.
/// @throws std::runtime_error where there are no samples of this kind of sensor
[[nodiscard]] std::string learnt_places(const std::vector<PlaceSample>& samples, SensorKind sensor);

}  // namespace roomatlas::bench
