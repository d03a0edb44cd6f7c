// SPDX-License-Identifier: GPL-3.0-or-later
// What was learnt of one kind of sensor. The numbers are printed by `./run bench trust train`.
#pragma once

#include "roomatlas/core/learnt_sum.hpp"
#include "roomatlas/mission/mission.hpp"

namespace roomatlas {

struct LearntModel {
  double lapses;          ///< share of maps that are wrong though no figure tells it, [0, 1)
  LearntSum right;        ///< log odds that all visits are right, of the others
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

}  // namespace roomatlas
