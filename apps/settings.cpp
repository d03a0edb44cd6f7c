// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings.hpp"

namespace roomatlas::apps {

void share(Settings& settings) {
  settings.simulation.footprint = settings.mission.footprint;
  settings.simulation.sonar_max_range_m = settings.mission.sonar_max_range_m;
}

}  // namespace roomatlas::apps
