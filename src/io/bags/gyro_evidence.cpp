// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/gyro_evidence.hpp"

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/core/median.hpp"
#include "roomatlas/core/pose2.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas::io {
namespace {

constexpr double kTurnedRad = radians(15.0);      // a stretch that turns less tells no turn's error
constexpr double kMostOffRad = radians(20.0);     // farther off, the sweeps slipped
constexpr int kLeastStretches = 6;                // fewer may agree by chance ...
constexpr double kLeastTurnRad = radians(270.0);  // ... and in fewer turns errors are small
constexpr double kLeastStillS = 2.0;              // of standing, from which drift is told
constexpr double kClearlyShare = 0.5;
constexpr double kWorthRad = radians(0.5);  // odometry that is off by less is good enough
constexpr double kNearerShare = 2.0 / 3.0;

double drift_about(const std::vector<TurnedStretch>& stretches, const Eigen::Vector3d& up) {
  double still_s = 0.0;
  double turned_rad = 0.0;
  std::vector<double> leads;
  for (const TurnedStretch& stretch : stretches) {
    const double by_gyro = up.dot(stretch.by_gyro_rad);
    if (stretch.stands) {
      still_s += stretch.passed_s;
      turned_rad += by_gyro;
    } else if (stretch.passed_s > 0.0) {
      leads.push_back((by_gyro - stretch.by_sweeps_rad) / stretch.passed_s);
    }
  }
  if (still_s >= kLeastStillS) return turned_rad / still_s;
  return leads.empty() ? 0.0 : median(std::move(leads));
}

GyroVerdict judge_about(const std::vector<TurnedStretch>& stretches, const Eigen::Vector3d& up) {
  GyroVerdict verdict;
  verdict.up = up;
  verdict.drift_rad_per_s = drift_about(stretches, up);
  int nearer = 0;
  for (const TurnedStretch& stretch : stretches) {
    if (std::abs(stretch.by_sweeps_rad) < kTurnedRad) continue;
    const double by_gyro = up.dot(stretch.by_gyro_rad) - verdict.drift_rad_per_s * stretch.passed_s;
    const auto off = [&](double turn_rad) {
      return std::min(kMostOffRad, std::abs(turn_rad - stretch.by_sweeps_rad));
    };
    const double gyro_off = off(by_gyro);
    const double odometry_off = off(stretch.by_odometry_rad);
    verdict.gyro_off_rad += gyro_off * gyro_off;
    verdict.odometry_off_rad += odometry_off * odometry_off;
    verdict.turned_rad += std::abs(stretch.by_sweeps_rad);
    ++verdict.stretches;
    if (gyro_off < odometry_off) ++nearer;
  }
  if (verdict.stretches == 0) return verdict;
  verdict.gyro_off_rad = std::sqrt(verdict.gyro_off_rad / verdict.stretches);
  verdict.odometry_off_rad = std::sqrt(verdict.odometry_off_rad / verdict.stretches);
  verdict.is_enough = verdict.stretches >= kLeastStretches && verdict.turned_rad >= kLeastTurnRad;
  verdict.gyro_is_better = verdict.is_enough && verdict.odometry_off_rad > kWorthRad &&
                           verdict.gyro_off_rad < kClearlyShare * verdict.odometry_off_rad &&
                           nearer >= kNearerShare * verdict.stretches;
  return verdict;
}

}  // namespace

GyroVerdict judge_gyro(const std::vector<TurnedStretch>& stretches,
                       const std::optional<Eigen::Vector3d>& up) {
  if (up) return judge_about(stretches, *up);
  GyroVerdict best = judge_about(stretches, Eigen::Vector3d::UnitZ());
  for (int i = 0; i < 6; ++i) {
    const Eigen::Vector3d axis = (i % 2 == 0 ? 1.0 : -1.0) * Eigen::Vector3d::Unit(2 - i / 2);
    const GyroVerdict verdict = judge_about(stretches, axis);
    if (verdict.gyro_off_rad < best.gyro_off_rad) best = verdict;
  }
  return best;
}

}  // namespace roomatlas::io
