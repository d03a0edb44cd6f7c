// SPDX-License-Identifier: GPL-3.0-or-later
#include "map_directions.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace roomatlas {
namespace {

constexpr std::size_t kBins = 360;  // a quarter of a degree each: finer than walls tell
constexpr double kBinRad = kPi / 2.0 / static_cast<double>(kBins);
constexpr double kBlurSigmas = 3.0;  // farther off, a wall counts for nothing

using Density = std::vector<double>;

/// Metres of wall by direction.
Density lengths_of(std::span<const WallSegment> segments, std::span<const Pose2> map_from_robot) {
  Density lengths(kBins, 0.0);
  for (const WallSegment& segment : segments) {
    const double at_rad =
        wrap_quarter(map_from_robot[segment.reading].theta_rad + segment.normal_rad) + kPi / 4.0;
    const auto bin = static_cast<std::size_t>(std::max(0.0, at_rad / kBinRad));
    lengths[bin % kBins] += segment.length_m;
  }
  return lengths;
}

Density blurred(const Density& lengths, double sigma_rad) {
  const double sigma = sigma_rad / kBinRad;
  const auto width = static_cast<std::size_t>(std::ceil(kBlurSigmas * sigma));
  Density result(kBins, 0.0);
  for (std::size_t i = 0; i < kBins; ++i) {
    for (std::size_t j = 0; j <= 2 * width; ++j) {
      const double off = (static_cast<double>(j) - static_cast<double>(width)) / sigma;
      result[i] += lengths[(i + j + kBins - width) % kBins] * std::exp(-off * off / 2.0);
    }
  }
  return result;
}

bool is_peak(const Density& density, std::size_t at) {
  return density[at] > density[(at + kBins - 1) % kBins] &&
         density[at] >= density[(at + 1) % kBins];
}

}  // namespace

std::vector<double> map_directions(std::span<const WallSegment> segments,
                                   std::span<const Pose2> map_from_robot,
                                   const MapDirectionsOptions& options) {
  const Density density = blurred(lengths_of(segments, map_from_robot), options.blur_rad);
  std::vector<std::size_t> bins(kBins);
  std::iota(bins.begin(), bins.end(), std::size_t{0});
  std::erase_if(bins, [&](std::size_t at) { return !is_peak(density, at); });
  std::stable_sort(bins.begin(), bins.end(),
                   [&](std::size_t a, std::size_t b) { return density[a] > density[b]; });
  std::vector<double> directions_rad;
  for (const std::size_t at : bins) {
    if (directions_rad.size() == options.most) break;
    if (density[at] < options.least_share * density[bins.front()]) break;
    const double rad = (static_cast<double>(at) + 0.5) * kBinRad - kPi / 4.0;
    const bool is_known =
        std::any_of(directions_rad.begin(), directions_rad.end(), [&](double other_rad) {
          return std::abs(wrap_quarter(rad - other_rad)) < options.least_apart_rad;
        });
    if (!is_known) directions_rad.push_back(rad);
  }
  return directions_rad;
}

}  // namespace roomatlas
