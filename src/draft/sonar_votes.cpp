// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_votes.hpp"

#include <array>
#include <cmath>
#include <map>

namespace roomatlas {
namespace {

constexpr std::array kAside_m = {-0.1, 0.0, 0.1};  // an echo speaks for this much of a wall
constexpr double kCoarse_deg = 1.0;                // between directions that are tried first ...
constexpr double kFine_deg = 0.125;                // ... and then around the best
constexpr double kFineReach_deg = 1.0;
constexpr double kAcross_m = 0.03;  // bins in which votes agree
constexpr double kAlong_m = 2.0;    // longer tells directions better, and few walls are longer
constexpr double kChance = 2.0;     // as many agree in a bin by chance

/// How well the votes for walls of one direction, in all its four ways, agree.
double agreement(double direction_rad, const std::vector<Echo>& echoes, double half_cone_rad,
                 double max_range_m) {
  double sum = 0.0;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double normal_rad = wrap_angle(direction_rad + quarter * kPi / 2.0);
    const Point2 normal = direction(normal_rad);
    const Point2 along = direction(normal_rad + kPi / 2.0);
    std::map<std::pair<int, int>, double> bins;
    for (const SurfacePoint& vote : votes_for(normal_rad, echoes, half_cone_rad, max_range_m)) {
      bins[{static_cast<int>(std::floor(vote.at.dot(normal) / kAcross_m)),
            static_cast<int>(std::floor(vote.at.dot(along) / kAlong_m))}] += vote.weight / 3.0;
    }
    for (const auto& [bin, votes] : bins) {
      if (votes > kChance) sum += (votes - kChance) * (votes - kChance);
    }
  }
  return sum;
}

}  // namespace

std::vector<SurfacePoint> votes_for(double normal_rad, const std::vector<Echo>& echoes,
                                    double half_cone_rad, double max_range_m) {
  const Point2 normal = direction(normal_rad);
  const Point2 along = direction(normal_rad + kPi / 2.0);
  std::vector<SurfacePoint> votes;
  for (const Echo& echo : echoes) {
    if (!echo.is_hit || echo.range_m >= max_range_m) continue;
    const double off_rad = wrap_angle(echo.building_from_beam.theta_rad + kPi - normal_rad);
    if (std::abs(off_rad) > half_cone_rad) continue;
    const Point2 foot = echo.building_from_beam.position() - echo.range_m * normal;
    for (const double aside_m : kAside_m) {
      votes.push_back({foot + aside_m * along, normal_rad, 1.0});
    }
  }
  return votes;
}

double best_direction_rad(const std::vector<Echo>& echoes, double half_cone_rad,
                          double max_range_m) {
  double best_rad = 0.0;
  double most = -1.0;
  const auto try_one = [&](double direction_rad) {
    const double agree = agreement(direction_rad, echoes, half_cone_rad, max_range_m);
    if (agree > most) {
      most = agree;
      best_rad = direction_rad;
    }
  };
  for (double deg = 0.0; deg < 90.0; deg += kCoarse_deg) try_one(deg * kPi / 180.0);
  const double coarse_rad = best_rad;
  for (double deg = -kFineReach_deg; deg <= kFineReach_deg; deg += kFine_deg) {
    try_one(coarse_rad + deg * kPi / 180.0);
  }
  const double quarter = kPi / 2.0;
  return best_rad - quarter * std::floor(best_rad / quarter);
}

}  // namespace roomatlas
