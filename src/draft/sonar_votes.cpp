// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_votes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "roomatlas/core/floored.hpp"
#include "roomatlas/core/for_each_index.hpp"

namespace roomatlas {
namespace {

constexpr std::array kAside_m = {-0.1, 0.0, 0.1};  // an echo speaks for this much of a wall
constexpr double kCoarse_deg = 1.0;                // between directions that are tried first ...
constexpr double kFine_deg = 0.125;                // ... and then around the best
constexpr double kFineReach_deg = 1.0;
constexpr double kVoteBin_m = 0.03;  // bins in which votes agree
constexpr double kAlong_m = 2.0;     // longer tells directions better, and few walls are longer
constexpr double kChance = 2.0;      // as many agree in a bin by chance

/// Votes by bins across and along, and what they add up to.
class VoteBins {
 public:
  VoteBins(const std::vector<SurfacePoint>& votes, const Point2& normal, const Point2& along) {
    if (votes.empty()) return;
    std::vector<Cell> cells;
    cells.reserve(votes.size());
    for (const SurfacePoint& vote : votes) {
      cells.push_back({static_cast<int>(floored(vote.at.dot(normal) / kVoteBin_m)),
                       static_cast<int>(floored(vote.at.dot(along) / kAlong_m))});
    }
    Cell low = cells.front();
    Cell high = low;
    for (const Cell& cell : cells) {
      low = {std::min(low.x, cell.x), std::min(low.y, cell.y)};
      high = {std::max(high.x, cell.x), std::max(high.y, cell.y)};
    }
    const auto columns = static_cast<std::size_t>(high.y - low.y) + 1;
    counts_.resize((static_cast<std::size_t>(high.x - low.x) + 1) * columns);
    for (const Cell& cell : cells) {
      ++counts_[static_cast<std::size_t>(cell.x - low.x) * columns +
                static_cast<std::size_t>(cell.y - low.y)];
    }
  }

  /// Visits what the votes of each bin weigh: a third each, added up one by one.
  template <typename Visit>
  void for_each(Visit visit) const {
    std::vector<double> weight_of = {0.0};  // by count
    for (const std::uint32_t count : counts_) {
      while (weight_of.size() <= count) weight_of.push_back(weight_of.back() + 1.0 / 3.0);
      visit(weight_of[count]);
    }
  }

 private:
  std::vector<std::uint32_t> counts_;
};

/// How well the votes for walls of one direction, in all its four ways, agree.
double agreement(double direction_rad, const std::vector<Echo>& echoes, double half_cone_rad,
                 double max_range_m) {
  double sum = 0.0;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double normal_rad = wrap_angle(direction_rad + quarter * kPi / 2.0);
    const VoteBins bins(votes_for(normal_rad, echoes, half_cone_rad, max_range_m),
                        direction(normal_rad), direction(normal_rad + kPi / 2.0));
    bins.for_each([&](double votes) {
      if (votes > kChance) sum += (votes - kChance) * (votes - kChance);
    });
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

double best_direction_rad(const std::vector<Echo>& echoes, double half_cone_rad, double max_range_m,
                          int jobs) {
  double best_rad = 0.0;
  double most = -1.0;
  const auto try_all = [&](const std::vector<double>& directions_rad) {
    const auto agree = results_of<double>(directions_rad.size(), jobs, [&](std::size_t i) {
      return agreement(directions_rad[i], echoes, half_cone_rad, max_range_m);
    });
    for (std::size_t i = 0; i < agree.size(); ++i) {
      if (agree[i] <= most) continue;
      most = agree[i];
      best_rad = directions_rad[i];
    }
  };
  std::vector<double> coarse;
  for (double deg = 0.0; deg < 90.0; deg += kCoarse_deg) coarse.push_back(deg * kPi / 180.0);
  try_all(coarse);
  std::vector<double> fine;
  for (double deg = -kFineReach_deg; deg <= kFineReach_deg; deg += kFine_deg) {
    fine.push_back(best_rad + deg * kPi / 180.0);
  }
  try_all(fine);
  const double quarter = kPi / 2.0;
  return best_rad - quarter * std::floor(best_rad / quarter);
}

}  // namespace roomatlas
