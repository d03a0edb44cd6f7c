// SPDX-License-Identifier: GPL-3.0-or-later
// What was learnt of one kind of sensor. The numbers are printed by `./run bench trust train`.
#pragma once

#include <span>
#include <vector>

#include "roomatlas/mission/mission.hpp"
#include "roomatlas/plan/judgement.hpp"

namespace roomatlas {

/// A figure's part in a sum.
struct LearntTerm {
  const char* name;
  double mean;       ///< over the missions that were learnt from
  double deviation;  ///< the same; at 3 of them figures are cut off
  double weight;     ///< of (figure - mean) / deviation
};

/// bias + the terms.
struct LearntSum {
  double bias;
  std::span<const LearntTerm> terms;
};

struct LearntModel {
  LearntSum right;        ///< log odds that all visits are right
  LearntSum place;        ///< log of the error bar in metres
  LearntSum heading;      ///< ... in degrees
  LearntSum scale;        ///< ... as a share
  LearntSum visit_right;  ///< log odds that a visit is right; has the map's own as `map`
  LearntSum visit_place;  ///< log of a visit's error bar in metres; the same
};

[[nodiscard]] const LearntModel& laser_model();
[[nodiscard]] const LearntModel& sonar_model();
[[nodiscard]] inline const LearntModel& model_of(SensorKind sensor) {
  return sensor == SensorKind::laser ? laser_model() : sonar_model();
}

/// A term's part for these figures.
/// @throws std::logic_error where they have none of its name
[[nodiscard]] double part_of(const LearntTerm& term, const std::vector<JudgedFigure>& figures);
[[nodiscard]] double sum_of(const LearntSum& sum, const std::vector<JudgedFigure>& figures);

}  // namespace roomatlas
