// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "models.hpp"

namespace roomatlas {
namespace {

constexpr int kMinPairs = 8;
constexpr double kMaxPerM = radians(3.5);
constexpr double kStepPerM = radians(0.05);
constexpr double kMaxPerRad = 0.06;
constexpr double kStepPerRad = 0.01;
constexpr double kSigmaRad = radians(3.0);  // of the walls' direction between two ASRs

/// How the walls' direction turned between two consecutive ASRs, and over what motion.
struct Pair {
  double turned_rad = 0.0;  // modulo 90 degrees; 0 without drift
  double driven_m = 0.0;    // from the middle of one ASR to the middle of the next
  double turn_rad = 0.0;    // the same
};

double mean_length_m(const Measurements& measurements, const Measurements::Edge& edge) {
  return (measurements.path_length_m[edge.from] + measurements.path_length_m[edge.to]) / 2.0;
}

double mean_turn_rad(const Measurements& measurements, const Measurements::Edge& edge) {
  return (measurements.turning[edge.from].signed_rad + measurements.turning[edge.to].signed_rad) /
         2.0;
}

std::vector<Pair> pairs_of(const Measurements& measurements) {
  std::vector<Pair> pairs;
  for (const Measurements::Edge& edge : measurements.driven) {
    const auto& before = measurements.walls[edge.from];
    const auto& after = measurements.walls[edge.to];
    if (!before || !after) continue;
    pairs.push_back({wrap_quarter(edge.measured.from_from_to.theta_rad + after->angle_rad -
                                  before->angle_rad),
                     mean_length_m(measurements, edge), mean_turn_rad(measurements, edge)});
  }
  return pairs;
}

double votes_for(const std::vector<Pair>& pairs, double per_m, double per_rad) {
  double votes = 0.0;
  for (const Pair& pair : pairs) {
    const double off =
        wrap_quarter(pair.turned_rad - per_m * pair.driven_m - per_rad * pair.turn_rad);
    votes += std::exp(-off * off / (2.0 * kSigmaRad * kSigmaRad));
  }
  return votes;
}

}  // namespace

HeadingBias estimate_heading_bias(const Measurements& measurements) {
  const std::vector<Pair> pairs = pairs_of(measurements);
  HeadingBias best;
  if (pairs.size() < kMinPairs) return best;
  best.pairs = static_cast<int>(pairs.size());
  double most = votes_for(pairs, 0.0, 0.0);
  const auto steps_per_m = static_cast<int>(std::lround(kMaxPerM / kStepPerM));
  const auto steps_per_rad = static_cast<int>(std::lround(kMaxPerRad / kStepPerRad));
  for (int i = -steps_per_m; i <= steps_per_m; ++i) {
    for (int j = -steps_per_rad; j <= steps_per_rad; ++j) {
      const double votes = votes_for(pairs, i * kStepPerM, j * kStepPerRad);
      if (votes <= most) continue;
      most = votes;
      best.rad_per_m = i * kStepPerM;
      best.rad_per_rad = j * kStepPerRad;
    }
  }
  return best;
}

void remove_bias(Measurements& measurements, const HeadingBias& bias) {
  measurements.bias = bias;
  for (Measurements::Edge& edge : measurements.driven) {
    const double drift = bias.rad_per_m * mean_length_m(measurements, edge) +
                         bias.rad_per_rad * mean_turn_rad(measurements, edge);
    double& heading = edge.measured.from_from_to.theta_rad;
    heading = wrap_angle(heading - drift);
  }
}

}  // namespace roomatlas
