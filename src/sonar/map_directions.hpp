// SPDX-License-Identifier: GPL-3.0-or-later
// The directions that walls follow on a map, whatever was thought of them before.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace roomatlas {

/// A stretch of wall on a map; those of a drive are in the order in which the robot heard them.
struct MapWall {
  double normal_rad = 0.0;  ///< direction of its normal in the map; counts modulo 90 degrees
  double length_m = 0.0;    ///< above 0
};

struct MapDirectionsOptions {
  double wall_sigma_rad = 0.044;   ///< 2.5 degrees: of a wall on the map, however long
  double end_sigma_m = 0.0175;     ///< divided by the length: sigma of a wall's direction by its
                                   ///< ends
  double far_sigmas = 3.0;         ///< from which on it does not matter how far off a wall is
  double share = 0.3;              ///< of what a wall would say alone: those of one wall agree
  double switch_cost = 7.0;        ///< of log likelihood: the walls around follow another direction
                                   ///< from here on. Smaller gives single walls their own
  double least_gain = 10.0;        ///< of log likelihood, that another direction must bring
  double least_apart_rad = 0.061;  ///< 3.5 degrees: nearer ones are one, seen with noise
  std::size_t most = 3;            ///< more gained nothing
};

/// Which of the directions each wall follows: the most likely course along the drive (Viterbi
/// 1967), so that a wing's walls follow one, however little it is turned.
/// @param directions_rad modulo 90 degrees; at least one
[[nodiscard]] std::vector<std::size_t> directions_followed(
    std::span<const MapWall> walls, std::span<const double> directions_rad,
    const MapDirectionsOptions& options = {});

/// How much of the walls lies within 5 degrees of the direction that it follows, [0, 1]: a wall of
/// a metre and more counts as one.
/// @param walls at least one
/// @param directions_rad as above
[[nodiscard]] double followed_share(std::span<const MapWall> walls,
                                    std::span<const double> directions_rad);

/// The directions, modulo 90 degrees in [-pi/4, pi/4), that the walls follow: the one that makes
/// them most likely, and others as long as each makes the course along the drive much more likely.
/// Empty without walls.
[[nodiscard]] std::vector<double> map_directions(std::span<const MapWall> walls,
                                                 const MapDirectionsOptions& options = {});

}  // namespace roomatlas
