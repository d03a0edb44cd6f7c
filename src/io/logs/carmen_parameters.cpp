// SPDX-License-Identifier: GPL-3.0-or-later
#include "carmen_parameters.hpp"

#include "roomatlas/mission/plausible.hpp"
#include "text/numbers.hpp"
#include "text/tokens.hpp"

#include <array>
#include <cmath>

namespace roomatlas::io {
namespace {

struct Known {
  std::string_view name;
  std::optional<double> CarmenParameters::*member;
  double least_m;
  double most_m;
};

// Sizes and ranges as the options of the same meaning allow.
constexpr std::array kKnown = {
    Known{"robot_length", &CarmenParameters::robot_length_m, 0.05, 5.0},
    Known{"robot_width", &CarmenParameters::robot_width_m, 0.05, 5.0},
    Known{"robot_frontlaser_offset", &CarmenParameters::front_laser_offset_m, -kFarthestMount_m,
          kFarthestMount_m},
    Known{"robot_rearlaser_offset", &CarmenParameters::rear_laser_offset_m, -kFarthestMount_m,
          kFarthestMount_m},
    Known{"robot_front_laser_max", &CarmenParameters::front_laser_max_range_m, 0.5, 1000.0},
    Known{"robot_rear_laser_max", &CarmenParameters::rear_laser_max_range_m, 0.5, 1000.0},
    Known{"robot_max_sonar", &CarmenParameters::sonar_max_range_m, 0.5, 100.0},
};

/// What a value that is no length of this kind was taken for.
std::string problem_of(const Known& known, std::string_view value, double number_m) {
  std::string problem = "expected a length in metres from " + shown(known.least_m) + " to " +
                        shown(known.most_m) + ", found " +
                        (value.empty() ? "the end of the line" : quoted(value));
  if (std::isfinite(number_m) && std::abs(number_m) > known.most_m) {
    problem += ", which looks like millimetres or centimetres";
  }
  return problem;
}

}  // namespace

std::string CarmenParameters::set(std::string_view name, std::string_view value) {
  for (const Known& known : kKnown) {
    if (known.name != name) continue;
    const double number_m = parse_number(value).value_or(std::nan(""));
    if (!(number_m >= known.least_m && number_m <= known.most_m)) {
      return problem_of(known, value, number_m);
    }
    this->*known.member = number_m;
    return "";
  }
  return "";
}

}  // namespace roomatlas::io
