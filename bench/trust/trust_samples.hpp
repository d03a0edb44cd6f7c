// SPDX-License-Identifier: GPL-3.0-or-later
// What `bench_everywhere` wrote of its missions, as samples to learn a judgement from.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "roomatlas/mission/mission.hpp"
#include "roomatlas/plan/judgement.hpp"

namespace roomatlas::bench {

struct TrustVisit {
  std::vector<JudgedFigure> figures;
  bool is_right = false;
  double place_m = 0.0;      ///< its error after fitting
  double said_m = 0.0;       ///< the error bar that the program gave it
  double probability = 0.0;  ///< that the program gave it
};

struct TrustSample {
  std::string name;  ///< seed and number of the case
  std::string stratum;
  SensorKind sensor = SensorKind::laser;
  std::vector<JudgedFigure> figures;
  bool is_right = false;
  double off = 0.0;          ///< the largest of its visits' places and rooms' headings, over what a
                             ///< right map may be off: above 1 it is wrong
  double place_m = 0.0;      ///< that 9 of 10 visits keep
  double heading_deg = 0.0;  ///< the largest of a visit
  double scale_share = 0.0;  ///< the larger of both axes
  Judgement said;            ///< by the program that built it
  std::vector<TrustVisit> visits;
};

/// The missions that came to a map, from files with one JSON object a line.
/// @throws std::runtime_error where a file cannot be read
[[nodiscard]] std::vector<TrustSample> read_samples(
    const std::vector<std::filesystem::path>& files);

}  // namespace roomatlas::bench
