// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "fit_sum.hpp"
#include "trust_samples.hpp"

namespace roomatlas::bench {

/// The error bars of a `LearntModel`.
struct LearntBars {
  SensorKind sensor = SensorKind::laser;
  std::size_t missions = 0;
  std::size_t visits = 0;
  Fitted place;
  Fitted heading;
  Fitted scale;
  Fitted visit_place;
};

/// What the library knows as `LearntModel`.
struct LearntTrust {
  std::size_t right = 0;
  Fitted mission_right;
  Fitted visit_right;
  LearntBars bars;
};

/// @throws std::runtime_error where there are no missions of this kind of sensor
[[nodiscard]] LearntTrust learn_trust(const std::vector<TrustSample>& samples, SensorKind sensor);

/// Bars alone, learnt further from what the library knows, with the probabilities of the program
/// that built the maps. A better program's errors are smaller, and few of its maps are wrong: what
/// is known of wrong ones stays, where nothing speaks against it.
/// @throws std::runtime_error where there are no missions of this kind of sensor
[[nodiscard]] LearntBars learn_bars(const std::vector<TrustSample>& samples, SensorKind sensor);

/// The source file of the library that holds it.
[[nodiscard]] std::string learnt_source(const LearntTrust& learnt);

/// The parts of that file that are bars.
[[nodiscard]] std::string bars_source(const LearntBars& learnt);

}  // namespace roomatlas::bench
