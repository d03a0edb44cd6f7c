// SPDX-License-Identifier: GPL-3.0-or-later
#include "odometer.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace roomatlas {
namespace {

constexpr double kSecondsPerHour = 3600.0;
constexpr double kSlipM = 0.5;             // of drive; a threshold, a wet spot, a cable
constexpr double kSpinShare = 0.5;         // that spinning wheels report more
constexpr double kSlipTurnDegPerM = 20.0;  // at most: one wheel spins more than the other

SimulationOptions without_faults(const OdometryErrors& errors, std::uint64_t seed) {
  SimulationOptions options;
  options.seed = seed;
  options.odometry = errors;
  return options;
}

}  // namespace

OdometryErrors odometry_errors(OdometryPreset preset) {
  switch (preset) {
    case OdometryPreset::mild:
      return {0.005, 0.1, 1.0, 0.0};
    case OdometryPreset::typical:
      return {0.01, 0.3, 2.0, 0.0};
    case OdometryPreset::hard:
      return {-0.04, 3.3, 2.0, -0.04};
  }
  throw std::invalid_argument("unknown odometry preset");
}

Odometer::Odometer(const SimulationOptions& options)
    : errors_(options.odometry),
      faults_(options.faults),
      track_m_(options.footprint.width_m),
      period_s_(1.0 / options.rate_hz),
      heading_noise_(options.seed, "odometry heading"),
      slips_(options.seed, "odometry slips"),
      dropouts_(options.seed, "encoder dropouts") {}

Odometer::Odometer(const OdometryErrors& errors, std::uint64_t seed)
    : Odometer(without_faults(errors, seed)) {}

void Odometer::tick() {
  if (faults_.dropouts_per_hour <= 0.0) return;
  dropout_left_s_ -= period_s_;
  if (dropout_left_s_ > 0.5 * period_s_) return;
  encoder_ = Encoder::both;
  const bool begins = dropouts_.uniform() < faults_.dropouts_per_hour / kSecondsPerHour * period_s_;
  const bool is_left = dropouts_.uniform() < 0.5;
  if (!begins) return;
  encoder_ = is_left ? Encoder::left_fails : Encoder::right_fails;
  dropout_left_s_ = faults_.dropout_s;
}

Odometer::Increment Odometer::counted(double length_m, double turn_rad) const {
  const double half_m = turn_rad * track_m_ / 2.0;
  const double left_m = encoder_ == Encoder::left_fails ? 0.0 : length_m - half_m;
  const double right_m = encoder_ == Encoder::right_fails ? 0.0 : length_m + half_m;
  return {(left_m + right_m) / 2.0, (right_m - left_m) / track_m_};
}

/// A new slip begins so often that the given share of all that is driven slips.
void Odometer::slip(double driven_m, Increment& reported) {
  if (slip_left_m_ <= 0.0) {
    const double rest = std::max(1e-9, 1.0 - faults_.slip_share);
    const bool begins = slips_.uniform() < faults_.slip_share / rest * driven_m / kSlipM;
    const double turn = 2.0 * slips_.uniform() - 1.0;
    if (!begins) return;
    slip_left_m_ = kSlipM;
    slip_turn_rad_per_m_ = radians(turn * kSlipTurnDegPerM);
  }
  const double slipping_m = std::min(driven_m, slip_left_m_);
  reported.length_m *= 1.0 + kSpinShare * slipping_m / driven_m;
  reported.turn_rad += slip_turn_rad_per_m_ * slipping_m;
  slip_left_m_ -= driven_m;
}

Odometer::Increment Odometer::add(double length_m, double turn_rad) {
  const double driven_m = std::abs(length_m);
  if (encoder_ != Encoder::both) {
    const Increment left = counted(length_m, turn_rad);
    length_m = left.length_m;
    turn_rad = left.turn_rad;
  }
  Increment reported{length_m * (1.0 + errors_.length_share),
                     turn_rad * (1.0 + errors_.turn_share)};
  if (driven_m > 0.0) {
    reported.turn_rad += radians(errors_.heading_bias_deg_per_m * driven_m);
    reported.turn_rad += radians(errors_.heading_noise_deg_per_sqrt_m * std::sqrt(driven_m)) *
                         heading_noise_.normal();
    if (faults_.slip_share > 0.0) slip(driven_m, reported);
  }
  // The heading error builds up along the way: half of it bends the first part of the step.
  const double half_turn_rad = reported.turn_rad / 2.0;
  odom_from_robot_ = odom_from_robot_ * Pose2{0.0, 0.0, half_turn_rad} *
                     Pose2{reported.length_m, 0.0, half_turn_rad};
  return reported;
}

}  // namespace roomatlas
