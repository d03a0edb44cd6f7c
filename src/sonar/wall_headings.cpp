// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_headings.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr double kEndsM = radians(1.0);  // over a wall's length: sigma of its direction by its ends
constexpr double kFarSigmas = 2.0;
constexpr double kLeastScatterM = 0.006;  // of a wall's returns: few lie on a line by chance

double square(double value) { return value * value; }

double variance_at_solution(const SeenWall& wall, const SonarBatchOptions& options) {
  const double scatter_m = std::max(kLeastScatterM, wall.sigma_m);
  return square(options.settled_heading_rad) +
         square(options.settled_scatter * scatter_m / std::pow(wall.length_m, 1.5));
}

}  // namespace

double sought_variance(const SeenWall& wall, const SonarBatchOptions& options) {
  return square(options.wall_heading_rad) + square(kEndsM / wall.length_m);
}

double sought_variance(const SeenWall& a, const SeenWall& b, const SonarBatchOptions& options) {
  return sought_variance(a, options) + square(kEndsM / b.length_m);
}

double far_squared(double sought_variance) { return square(kFarSigmas) * sought_variance; }

double heading_information(const SeenWall& wall, const SonarBatchOptions& options) {
  const double share = std::min(1.0, wall.length_m);
  return options.is_settled
             ? options.settled_heading_weight * share / variance_at_solution(wall, options)
             : options.heading_weight * share / sought_variance(wall, options);
}

}  // namespace roomatlas
