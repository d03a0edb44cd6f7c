// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace roomatlas {

/// How far the measures of a plan can be relied on: standard deviations in metres, each of a length
/// of its kind. What is not there could not be estimated.
struct PlanAccuracy {
  std::optional<double> within_room_m;    ///< scatter of the readings about the drawn walls
  std::optional<double> between_rooms_m;  ///< of where rooms are relative to each other
  std::optional<double> over_building_m;  ///< of the longer side as a whole, errors that all
                                          ///< measurements share included
  double extent_m = 0.0;                  ///< that side
  int loops = 0;  ///< places seen again that hold the map together; none: it may be bent unseen
};

}  // namespace roomatlas
