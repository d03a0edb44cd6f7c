// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "fit_sum.hpp"
#include "trust_samples.hpp"

namespace roomatlas::bench {

/// What the library knows as `LearntModel`.
struct LearntTrust {
  SensorKind sensor = SensorKind::laser;
  std::size_t missions = 0;
  std::size_t right = 0;
  std::size_t visits = 0;
  Fitted mission_right;
  Fitted place;
  Fitted heading;
  Fitted scale;
  Fitted visit_right;
  Fitted visit_place;
};

/// @throws std::runtime_error where there are no missions of this kind of sensor
[[nodiscard]] LearntTrust learn_trust(const std::vector<TrustSample>& samples, SensorKind sensor);

/// The source file of the library that holds it.
[[nodiscard]] std::string learnt_source(const LearntTrust& learnt);

}  // namespace roomatlas::bench
