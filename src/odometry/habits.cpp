// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/odometry/habits.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr double kStretchM = 1.0;               // of way, or ...
constexpr double kStretchRad = 0.8;             // ... of turns: a stretch ends
constexpr double kMaxErrorRad = radians(20.0);  // farther off, the match or the log jumped

// a stretch's heading beyond the habits: by way, by turns, and of the match
constexpr double kHeadingPerSqrtM = radians(1.0);
constexpr double kHeadingPerTurn = 0.03;
constexpr double kMatchedRad = radians(0.3);
constexpr double kLengthSigmaM = 0.03;
constexpr double kLeastLengthM = 0.5;
constexpr double kStraightRad = 0.5;

// of the habits, before anything is known
constexpr double kBiasSigma = radians(2.0);  // a metre
constexpr double kGainSigma = 0.05;
constexpr double kScaleSigma = 0.03;

constexpr double kRobust = 4.0;  // squared sigmas, Cauchy

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
  const double variance = squared(kHeadingPerSqrtM) * std::abs(stretch_.forwards_m) +
                          squared(kHeadingPerTurn * stretch_.turned_rad) + squared(kMatchedRad);
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
