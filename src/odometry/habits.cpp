// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/odometry/habits.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

#include "roomatlas/odometry/noise.hpp"

namespace roomatlas {
namespace {

constexpr double kStretchM = 1.0;    // of way, or ...
constexpr double kStretchRad = 0.8;  // ... of turns: a stretch ends. Shorter, the match's
                                     // own error counts; longer, few are learnt from
constexpr double kMaxErrorRad = radians(20.0);  // farther off, the match or the log jumped

/// Of a stretch's heading beyond the habits: 1 degree/sqrt(m), 3 % of the turns, and 0.3 degrees of
/// the match. As in a sonar mission's batch, but for the match.
constexpr MotionSigma kHeading{.still = radians(0.3), .per_sqrt_m = radians(1.0), .per_rad = 0.03};
constexpr double kLengthSigmaM = 0.03;  // of a stretch's length beyond its scale, and of the match
constexpr double kLeastLengthM = 0.5;   // a shorter stretch says nothing of the scale
constexpr double kStraightRad = 0.5;    // one that turns more has a chord that is no length

// Of the habits, before anything is known: recorded logs have up to 3.3 degrees a metre, gains of
// 0.95 and scales of 0.96. Smaller ones keep true habits from being learnt, larger ones learn
// noise.
constexpr double kBiasSigma = radians(2.0);  // rad a metre
constexpr double kGainSigma = 0.05;          // share of the turns
constexpr double kScaleSigma = 0.03;         // share of the lengths

constexpr double kRobust = 4.0;  // squared sigmas from which on Cauchy's loss lets go

double squared(double value) { return value * value; }

double loss(double residual, double variance) {
  return std::log1p(squared(residual) / (kRobust * variance));
}

/// Of a regression, for Cauchy's loss.
double weight(double residual, double variance) {
  return 1.0 / (variance * (1.0 + squared(residual) / (kRobust * variance)));
}

}  // namespace

Pose2 without_habits(const Pose2& step, const OdometryHabits& habits) {
  const double length_m = step.position().norm();
  const double forwards_m = step.x_m < 0.0 ? -length_m : length_m;
  return {habits.length_scale * step.x_m, habits.length_scale * step.y_m,
          habits.turn_gain * step.theta_rad + habits.bias_rad_per_m * forwards_m};
}

void HabitLearner::add(const Pose2& odometry, const Pose2& matched, bool is_length_seen) {
  stretch_.odometry = stretch_.odometry * odometry;
  stretch_.matched = stretch_.matched * matched;
  const double length_m = odometry.position().norm();
  stretch_.forwards_m += odometry.x_m < 0.0 ? -length_m : length_m;
  stretch_.turned_rad += std::abs(odometry.theta_rad);
  stretch_.is_length_seen = stretch_.is_length_seen && is_length_seen;
  if (std::abs(stretch_.forwards_m) < kStretchM && stretch_.turned_rad < kStretchRad) return;
  learn_heading();
  learn_length();
  stretch_ = {};
}

void HabitLearner::learn_heading() {
  const double error = wrap_angle(stretch_.matched.theta_rad - stretch_.odometry.theta_rad);
  if (std::abs(error) > kMaxErrorRad) return;
  const Eigen::Vector2d by{stretch_.forwards_m, stretch_.odometry.theta_rad};
  const double variance =
      sum_of_squares(kHeading, std::abs(stretch_.forwards_m), stretch_.turned_rad);
  const double residual = error - by.dot(bias_and_gain_);
  headings_.without += loss(error, variance);
  headings_.with += loss(residual, variance);
  const double its_weight = weight(residual, variance);
  heading_information_ += its_weight * by * by.transpose();
  heading_sum_ += its_weight * error * by;
  Eigen::Matrix2d with_prior = heading_information_;
  with_prior.diagonal() += Eigen::Vector2d(1.0 / squared(kBiasSigma), 1.0 / squared(kGainSigma));
  bias_and_gain_ = with_prior.ldlt().solve(heading_sum_);
  ++stretches_;
}

void HabitLearner::learn_length() {
  const double reported_m = stretch_.odometry.position().norm();
  if (!stretch_.is_length_seen || reported_m < kLeastLengthM ||
      stretch_.turned_rad > kStraightRad) {
    return;
  }
  const double more_m = stretch_.matched.position().norm() - reported_m;
  const double residual_m = more_m - more_length_ * reported_m;
  const double variance = squared(kLengthSigmaM);
  lengths_.without += loss(more_m, variance);
  lengths_.with += loss(residual_m, variance);
  const double its_weight = weight(residual_m, variance);
  length_information_ += its_weight * squared(reported_m);
  length_sum_ += its_weight * reported_m * more_m;
  more_length_ = length_sum_ / (length_information_ + 1.0 / squared(kScaleSigma));
}

OdometryHabits HabitLearner::habits() const {
  OdometryHabits habits;
  if (headings_.is_better()) {
    habits.bias_rad_per_m = bias_and_gain_.x();
    habits.turn_gain = 1.0 + bias_and_gain_.y();
  }
  if (lengths_.is_better()) habits.length_scale = 1.0 + more_length_;
  return habits;
}

}  // namespace roomatlas
