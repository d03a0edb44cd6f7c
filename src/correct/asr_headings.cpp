// SPDX-License-Identifier: GPL-3.0-or-later
#include "asr_headings.hpp"

#include <algorithm>
#include <cmath>

#include "roomatlas/odometry/heading_chain.hpp"

namespace roomatlas {
namespace {

constexpr HeadingStates kStates = {90};  // one a degree: a room's walls are known to 2 at best
constexpr auto kCount = static_cast<double>(kStates.corrections);
constexpr double kTrustInWalls = 0.7;  // the rest are uniform: a room's walls may lie at odd angles
constexpr double kUniform = 1.0 / kCount;

double correction_rad(std::size_t state) { return static_cast<double>(state) * kStates.step_rad(); }

constexpr double kSharpest_rad = kStates.step_rad() / 10.0;  // sigma: a sharper wall has no state

/// Likelihood of being off, in proportion. Beyond ten sigmas (e^-50) it is less than the last bit
/// of any sum that it would be added to.
double normal(double off_rad, double sigma_rad) {
  const double off = off_rad / sigma_rad;
  return std::abs(off) > 10.0 ? 0.0 : std::exp(-off * off / 2.0);
}

/// A normal distribution of the drift around none.
HeadingDrift drift_of(double sigma_rad) {
  constexpr double kNegligible = 1e-6;  // of the share: a move that costs time alone
  HeadingBelief shares;
  for (std::size_t s = 0; s < kStates.corrections; ++s) {
    shares.push_back(normal(wrap_quarter(correction_rad(s)), sigma_rad));
  }
  normalise(shares);
  HeadingDrift drift;
  for (std::size_t s = 0; s < kStates.corrections; ++s) {
    if (shares[s] < kNegligible) continue;
    const int steps = static_cast<int>(s);
    const int count = static_cast<int>(kStates.corrections);
    drift.push_back({2 * steps < count ? steps : steps - count, shares[s]});
  }
  return drift;
}

/// Likelihood of a wall direction for each correction, summing to 1; flat where an ASR has none.
void set_belief(HeadingBelief& belief, const std::optional<WallDirection>& wall,
                double odometry_rad, const CorrectOptions& options) {
  belief.assign(kStates.size(), kUniform);
  if (!wall) return;
  const double sigma_rad = std::max(wall_sigma_rad(*wall, options), kSharpest_rad);
  for (std::size_t s = 0; s < kStates.corrections; ++s) {
    const double heading = odometry_rad + correction_rad(s);
    belief[s] = normal(wrap_quarter(heading + wall->angle_rad), sigma_rad);
  }
  normalise(belief);
  for (double& value : belief) {
    value = (1.0 - kTrustInWalls) * kUniform + kTrustInWalls * value;
  }
}

/// Circular mean, [-pi/4, pi/4).
double mean_of(const HeadingBelief& belief) {
  Point2 sum = Point2::Zero();
  for (std::size_t s = 0; s < kStates.corrections; ++s) {
    sum += belief[s] * direction(4.0 * correction_rad(s));
  }
  return wrap_quarter(std::atan2(sum.y(), sum.x()) / 4.0);
}

/// A driven heading, once the habits are taken out.
double heading_without(const OdometryHabits& habits, const Measurements& measurements,
                       const Measurements::Edge& edge) {
  const auto mean = [](double a, double b) { return (a + b) / 2.0; };
  const double driven_m =
      mean(measurements.path_length_m[edge.from], measurements.path_length_m[edge.to]);
  const double turned_rad =
      mean(measurements.turning[edge.from].signed_rad, measurements.turning[edge.to].signed_rad);
  return wrap_angle(edge.measured.from_from_to.theta_rad + habits.bias_rad_per_m * driven_m +
                    (habits.turn_gain - 1.0) * turned_rad);
}

/// The chain without evidence. How uncertain a heading is does not hang on habits.
HeadingChain drifting(const Measurements& measurements, const CorrectOptions& options) {
  HeadingChain chain;
  chain.states = kStates;
  chain.scaling = MessageScaling::after_evidence;
  chain.evidence.resize(measurements.ids.size());
  chain.drift.resize(measurements.ids.size());
  for (const Measurements::Edge& edge : measurements.driven) {
    if (edge.to != edge.from + 1) continue;
    chain.drift[edge.to] = drift_of(sigmas_of(edge.measured, options).heading_rad);
  }
  return chain;
}

/// What the walls say of odometry without these habits. The chain keeps its memory.
void set_evidence(HeadingChain& chain, const Measurements& measurements,
                  const OdometryHabits& habits, const CorrectOptions& options) {
  std::vector<double> odometry_rad;
  odometry_rad.reserve(measurements.ids.size());
  for (const Pose2& pose : measurements.odom_from_asr) odometry_rad.push_back(pose.theta_rad);
  for (const Measurements::Edge& edge : measurements.driven) {
    if (edge.to != edge.from + 1) continue;
    odometry_rad[edge.to] = odometry_rad[edge.from] + heading_without(habits, measurements, edge);
  }
  for (std::size_t i = 0; i < odometry_rad.size(); ++i) {
    set_belief(chain.evidence[i], measurements.walls[i], odometry_rad[i], options);
  }
}

}  // namespace

AsrHeadings asr_headings(const Measurements& measurements, const OdometryHabits& habits,
                         const CorrectOptions& options) {
  HeadingChain chain = drifting(measurements, options);
  set_evidence(chain, measurements, habits, options);
  HeadingPosterior found = posterior(chain);
  AsrHeadings result;
  result.log_evidence = found.log_evidence;
  result.correction_rad.assign(found.beliefs.size(), 0.0);
  if (std::none_of(measurements.walls.begin(), measurements.walls.end(),
                   [](const auto& wall) { return wall.has_value(); })) {
    return result;
  }
  double start = 0.0;
  for (std::size_t i = 0; i < found.beliefs.size(); ++i) {
    normalise(found.beliefs[i]);
    const double mean = mean_of(found.beliefs[i]);
    const bool starts = chain.drift[i].empty();
    if (starts) start = mean;
    const double before = starts ? 0.0 : result.correction_rad[i - 1];
    result.correction_rad[i] = before + wrap_quarter(mean - start - before);
  }
  return result;
}

EstimatedHabits estimate_habits(const Measurements& measurements, const CorrectOptions& options) {
  constexpr int kMinAsrs = 8;  // fewer cannot tell a habit from noise
  // of the priors at none, without which a mission with few turns gets any gain
  constexpr double kBiasSigma = radians(1.0);  // a metre
  constexpr double kGainSigma = 0.03;
  EstimatedHabits best;
  const auto walls = std::count_if(measurements.walls.begin(), measurements.walls.end(),
                                   [](const auto& wall) { return wall.has_value(); });
  if (walls < kMinAsrs) return best;
  best.asrs = static_cast<int>(walls);
  HeadingChain chain = drifting(measurements, options);
  const auto score = [&](const OdometryHabits& habits) {
    const double bias = habits.bias_rad_per_m / kBiasSigma;
    const double gain = (habits.turn_gain - 1.0) / kGainSigma;
    set_evidence(chain, measurements, habits, options);
    return log_evidence(chain) - (bias * bias + gain * gain) / 2.0;
  };
  double highest = score(best.habits);
  const auto search = [&](double bias_step, int bias_steps, double gain_step, int gain_steps) {
    for (int i = bias_steps; i >= -bias_steps; --i) {
      for (int j = gain_steps; j >= -gain_steps; --j) {
        OdometryHabits habits = best.habits;  // steps are taken from the best so far
        habits.bias_rad_per_m += i * bias_step;
        habits.turn_gain += j * gain_step;
        const double now = score(habits);
        if (now <= highest) continue;
        highest = now;
        best.habits = habits;
      }
    }
  };
  // 3.3 degrees a metre and a gain of 0.95 are the worst that was met on a recorded log
  search(radians(0.25), 14, 0.02, 3);
  search(radians(0.05), 4, 0.01, 1);
  return best;
}

void take_out_habits(Measurements& measurements, const OdometryHabits& habits) {
  for (Measurements::Edge& edge : measurements.driven) {
    edge.measured.from_from_to.theta_rad = heading_without(habits, measurements, edge);
  }
}

}  // namespace roomatlas
