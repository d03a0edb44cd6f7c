// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "models.hpp"

namespace roomatlas {
namespace {

constexpr std::size_t kStates = 90;  // one a degree of the correction, modulo 90 degrees
constexpr double kStateRad = kPi / 2.0 / kStates;
constexpr double kTrustInWalls = 0.7;
constexpr double kUniform = 1.0 / kStates;

using Belief = std::array<double, kStates>;  // sums to 1

Belief normal_around_zero(double sigma_rad) {
  Belief belief{};
  double sum = 0.0;
  for (std::size_t s = 0; s < kStates; ++s) {
    const double off = wrap_quarter(static_cast<double>(s) * kStateRad) / sigma_rad;
    belief[s] = std::exp(-off * off / 2.0);
    sum += belief[s];
  }
  for (double& value : belief) value /= sum;
  return belief;
}

/// Likelihood of a wall direction for each correction; flat where an ASR has none.
Belief likelihood(const std::optional<WallDirection>& wall, double odometry_rad,
                  const CorrectOptions& options) {
  Belief belief;
  belief.fill(kUniform);
  if (!wall) return belief;
  const double sigma_rad = wall_sigma_rad(*wall, options);
  double sum = 0.0;
  Belief normal{};
  for (std::size_t s = 0; s < kStates; ++s) {
    const double heading = odometry_rad + static_cast<double>(s) * kStateRad;
    const double off = wrap_quarter(heading + wall->angle_rad) / sigma_rad;
    normal[s] = std::exp(-off * off / 2.0);
    sum += normal[s];
  }
  for (std::size_t s = 0; s < kStates; ++s) {
    belief[s] = (1.0 - kTrustInWalls) * kUniform + kTrustInWalls * normal[s] / sum;
  }
  return belief;
}

/// The belief after drift: a circular convolution, cut where the kernel is negligible.
Belief spread(const Belief& belief, const Belief& kernel) {
  constexpr double kNegligible = 1e-6;
  Belief result{};
  for (std::size_t shift = 0; shift < kStates; ++shift) {
    if (kernel[shift] < kNegligible) continue;
    // in two stretches, so that the compiler can do several states at once
    for (std::size_t s = 0; s < kStates - shift; ++s) {
      result[s + shift] += kernel[shift] * belief[s];
    }
    for (std::size_t s = kStates - shift; s < kStates; ++s) {
      result[s + shift - kStates] += kernel[shift] * belief[s];
    }
  }
  return result;
}

/// Multiplies and normalises; returns the sum before.
double weigh(Belief& belief, const Belief& by) {
  double sum = 0.0;
  for (std::size_t s = 0; s < kStates; ++s) sum += belief[s] *= by[s];
  for (double& value : belief) value /= sum;
  return sum;
}

/// Circular mean, [-pi/4, pi/4).
double mean_of(const Belief& belief) {
  Point2 sum = Point2::Zero();
  for (std::size_t s = 0; s < kStates; ++s) {
    sum += belief[s] * direction(4.0 * static_cast<double>(s) * kStateRad);
  }
  return wrap_quarter(std::atan2(sum.y(), sum.x()) / 4.0);
}

/// The mission as the model sees it.
struct Chain {
  std::vector<Belief> wall;   // likelihood at each ASR
  std::vector<Belief> drift;  // from the ASR before; unused where `starts`
  std::vector<bool> starts;   // no driven edge leads here from an earlier ASR
};

Chain chain_of(const Measurements& measurements, const HeadingBias& bias,
               const CorrectOptions& options) {
  const std::size_t count = measurements.ids.size();
  Measurements unbiased = measurements;
  remove_bias(unbiased, bias);
  std::vector<double> odometry_rad(count);
  Chain chain{std::vector<Belief>(count), std::vector<Belief>(count),
              std::vector<bool>(count, true)};
  for (std::size_t i = 0; i < count; ++i) odometry_rad[i] = measurements.odom_from_asr[i].theta_rad;
  for (const Measurements::Edge& edge : unbiased.driven) {
    if (edge.to != edge.from + 1) continue;
    odometry_rad[edge.to] = odometry_rad[edge.from] + edge.measured.from_from_to.theta_rad;
    chain.drift[edge.to] = normal_around_zero(sigmas_of(edge.measured, options).heading_rad);
    chain.starts[edge.to] = false;
  }
  for (std::size_t i = 0; i < count; ++i) {
    chain.wall[i] = likelihood(measurements.walls[i], odometry_rad[i], options);
  }
  return chain;
}

/// Forward pass: the belief at each ASR from what came before.
std::vector<Belief> filter(const Chain& chain, double& log_evidence) {
  std::vector<Belief> beliefs;
  Belief flat;
  flat.fill(kUniform);
  for (std::size_t i = 0; i < chain.wall.size(); ++i) {
    beliefs.push_back(chain.starts[i] ? flat : spread(beliefs.back(), chain.drift[i]));
    log_evidence += std::log(weigh(beliefs.back(), chain.wall[i]));
  }
  return beliefs;
}

}  // namespace

SmoothedHeadings smooth_headings(const Measurements& measurements, const HeadingBias& bias,
                                 const CorrectOptions& options) {
  const Chain chain = chain_of(measurements, bias, options);
  SmoothedHeadings result;
  std::vector<Belief> beliefs = filter(chain, result.log_evidence);
  result.correction_rad.assign(beliefs.size(), 0.0);
  if (std::none_of(measurements.walls.begin(), measurements.walls.end(),
                   [](const auto& wall) { return wall.has_value(); })) {
    return result;
  }
  Belief later;  // what the ASRs behind say of this one
  later.fill(kUniform);
  for (std::size_t i = beliefs.size(); i-- > 0;) {
    weigh(beliefs[i], later);
    if (i == 0) break;
    weigh(later, chain.wall[i]);
    later = spread(later, chain.drift[i]);  // the drift is as likely one way as the other
    if (chain.starts[i]) later.fill(kUniform);
  }
  double start = 0.0;
  for (std::size_t i = 0; i < beliefs.size(); ++i) {
    const double mean = mean_of(beliefs[i]);
    if (chain.starts[i]) start = mean;
    const double before = chain.starts[i] ? 0.0 : result.correction_rad[i - 1];
    result.correction_rad[i] = before + wrap_quarter(mean - start - before);
  }
  return result;
}

HeadingBias estimate_heading_bias(const Measurements& measurements, const CorrectOptions& options) {
  constexpr int kMinAsrs = 8;
  constexpr double kPriorPerM = radians(1.0);
  constexpr double kPriorPerRad = 0.03;
  HeadingBias best;
  const auto walls = std::count_if(measurements.walls.begin(), measurements.walls.end(),
                                   [](const auto& wall) { return wall.has_value(); });
  if (walls < kMinAsrs) return best;
  best.asrs = static_cast<int>(walls);
  const auto score = [&](const HeadingBias& bias) {
    double log_evidence = 0.0;
    (void)filter(chain_of(measurements, bias, options), log_evidence);
    const double per_m = bias.rad_per_m / kPriorPerM;
    const double per_rad = bias.rad_per_rad / kPriorPerRad;
    return log_evidence - (per_m * per_m + per_rad * per_rad) / 2.0;
  };
  double highest = score(best);
  const auto search = [&](const HeadingBias& around, double step_per_m, int steps_per_m,
                          double step_per_rad, int steps_per_rad) {
    for (int i = -steps_per_m; i <= steps_per_m; ++i) {
      for (int j = -steps_per_rad; j <= steps_per_rad; ++j) {
        const HeadingBias bias{around.rad_per_m + i * step_per_m,
                               around.rad_per_rad + j * step_per_rad, best.asrs};
        const double now = score(bias);
        if (now <= highest) continue;
        highest = now;
        best = bias;
      }
    }
  };
  search(best, radians(0.25), 14, 0.02, 3);
  search(best, radians(0.05), 4, 0.01, 1);
  return best;
}

void remove_bias(Measurements& measurements, const HeadingBias& bias) {
  measurements.bias = bias;
  const auto mean = [](double a, double b) { return (a + b) / 2.0; };
  for (Measurements::Edge& edge : measurements.driven) {
    const double driven_m =
        mean(measurements.path_length_m[edge.from], measurements.path_length_m[edge.to]);
    const double turned_rad =
        mean(measurements.turning[edge.from].signed_rad, measurements.turning[edge.to].signed_rad);
    double& heading = edge.measured.from_from_to.theta_rad;
    heading = wrap_angle(heading - bias.rad_per_m * driven_m - bias.rad_per_rad * turned_rad);
  }
}

}  // namespace roomatlas
