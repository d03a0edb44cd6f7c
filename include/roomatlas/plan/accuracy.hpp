// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace roomatlas {

/// How far the measures of a plan can be relied on. What is not there could not be estimated.
struct PlanAccuracy {
  std::optional<double> within_room_m;    ///< scatter of the readings about the drawn walls, one
                                          ///< standard deviation
  std::optional<double> between_rooms_m;  ///< error bar of where rooms are: 9 of 10 hold
  std::optional<double> over_building_m;  ///< the same of the longer side as a whole
  double extent_m = 0.0;                  ///< that side
  std::optional<double> probability;      ///< that the map is right, [0, 1]
};

}  // namespace roomatlas
