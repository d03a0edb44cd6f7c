// SPDX-License-Identifier: GPL-3.0-or-later
#include "carmen_parameters.hpp"

#include "numbers.hpp"

#include <array>
#include <cmath>

namespace roomatlas::io {
namespace {

struct Known {
  std::string_view name;
  std::optional<double> CarmenParameters::*member;
  bool positive;
};

constexpr std::array kKnown = {
    Known{"robot_length", &CarmenParameters::robot_length_m, true},
    Known{"robot_width", &CarmenParameters::robot_width_m, true},
    Known{"robot_frontlaser_offset", &CarmenParameters::front_laser_offset_m, false},
    Known{"robot_rearlaser_offset", &CarmenParameters::rear_laser_offset_m, false},
    Known{"robot_front_laser_max", &CarmenParameters::front_laser_max_range_m, true},
    Known{"robot_rear_laser_max", &CarmenParameters::rear_laser_max_range_m, true},
    Known{"robot_max_sonar", &CarmenParameters::sonar_max_range_m, true},
};

}  // namespace

bool CarmenParameters::set(std::string_view name, std::string_view value) {
  for (const Known& known : kKnown) {
    if (known.name != name) continue;
    const std::optional<double> number = parse_number(value);
    if (!number || !std::isfinite(*number) || (known.positive && *number <= 0.0)) return false;
    this->*known.member = *number;
    return true;
  }
  return true;
}

}  // namespace roomatlas::io
