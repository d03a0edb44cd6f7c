// SPDX-License-Identifier: GPL-3.0-or-later
// How GoogleTest shows values in the names of tests, instead of their bytes.
#pragma once

#include <ostream>

#include "roomatlas/mission/mission.hpp"

namespace roomatlas {

inline void PrintTo(SensorKind kind, std::ostream* out) {
  *out << (kind == SensorKind::sonar ? "sonar" : "laser");
}

}  // namespace roomatlas
