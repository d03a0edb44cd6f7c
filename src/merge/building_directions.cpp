// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring_edges.hpp"
#include "roomatlas/merge/regular_walls.hpp"
#include "wall_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace roomatlas {
namespace {

constexpr std::size_t kBins = 360;     // of a quarter turn: 0.25 degrees each
constexpr std::size_t kSmoothing = 6;  // bins to each side

/// Length of edges over their direction modulo a quarter turn.
class Histogram {
 public:
  void add(const Point2& along) {
    angles_.push_back({quarter_angle(along), along.norm()});
    total_m_ += along.norm();
  }
  [[nodiscard]] double total_m() const { return total_m_; }
  /// The mean of the edges about the smoothed maximum, without those near the given directions.
  struct Peak {
    double angle_rad = 0.0;
    double length_m = 0.0;
  };
  [[nodiscard]] std::optional<Peak> strongest(const std::vector<double>& taken,
                                              double apart_rad) const;

 private:
  struct Entry {
    double angle_rad;
    double length_m;
  };
  std::vector<Entry> angles_;
  double total_m_ = 0.0;
};

std::optional<Histogram::Peak> Histogram::strongest(const std::vector<double>& taken,
                                                    double apart_rad) const {
  std::array<double, kBins> bins{};
  std::vector<Entry> free;
  for (const Entry& entry : angles_) {
    const bool is_free = std::none_of(taken.begin(), taken.end(), [&](double direction) {
      return std::abs(quarter_difference(entry.angle_rad, direction)) <= apart_rad;
    });
    if (!is_free) continue;
    free.push_back(entry);
    const auto bin = static_cast<std::size_t>(entry.angle_rad / kQuarter_rad * kBins);
    bins[std::min(bin, kBins - 1)] += entry.length_m;
  }
  std::size_t best = 0;
  double most = 0.0;
  for (std::size_t centre = 0; centre < kBins; ++centre) {
    double sum = 0.0;
    for (std::size_t k = 0; k <= 2 * kSmoothing; ++k) {
      const double weight = static_cast<double>(kSmoothing + 1) -
                            std::abs(static_cast<double>(k) - static_cast<double>(kSmoothing));
      sum += weight * bins[(centre + k + kBins - kSmoothing) % kBins];
    }
    if (sum <= most) continue;
    most = sum;
    best = centre;
  }
  if (most <= 0.0) return std::nullopt;
  const double bin_rad = kQuarter_rad / kBins;
  const double about = (static_cast<double>(best) + 0.5) * bin_rad;
  Peak peak;
  double shift = 0.0;
  for (const Entry& entry : free) {
    const double off = quarter_difference(entry.angle_rad, about);
    if (std::abs(off) > bin_rad * kSmoothing) continue;
    shift += off * entry.length_m;
    peak.length_m += entry.length_m;
  }
  if (peak.length_m <= 0.0) return std::nullopt;
  peak.angle_rad = std::fmod(about + shift / peak.length_m + kQuarter_rad, kQuarter_rad);
  return peak;
}

}  // namespace

std::vector<double> building_directions(const std::vector<PlacedOutline>& outlines,
                                        const RegularWallOptions& options) {
  Histogram histogram;
  for_each_ring(outlines, [&](const Ring& ring) {
    for_each_edge(ring, [&](const Point2& a, const Point2& b) {
      if ((b - a).norm() >= options.min_wall_m) histogram.add(b - a);
    });
  });
  std::vector<double> directions;
  while (const auto peak = histogram.strongest(directions, 2.0 * radians(options.max_turn_deg))) {
    const double least_m = options.min_direction_share * histogram.total_m();
    if (!directions.empty() && peak->length_m < least_m) break;
    directions.push_back(peak->angle_rad);
  }
  return directions;
}

}  // namespace roomatlas
