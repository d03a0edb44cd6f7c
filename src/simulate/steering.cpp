// SPDX-License-Identifier: GPL-3.0-or-later
#include "steering.hpp"

#include "roomatlas/grid/polar_histogram.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace roomatlas {
namespace {

constexpr double kLookAheadM = 0.45;       // along the way; more cuts corners
constexpr double kWindowM = 0.9;           // of the polar histogram; more shies from far walls
constexpr double kSectorDeg = 5.0;         // of the histogram; wider smooths gaps away
constexpr double kMaxDeviationDeg = 30.0;  // from the way; more wanders off it along walls
constexpr double kDensityOfWall = 1000.0;  // k that weighs like a deviation of 30 degrees
constexpr double kTurnOnSpotDeg = 30.0;    // with more to turn it does not drive
constexpr double kCreepSlower = 3.0;       // times slower where it is tight
constexpr double kSlowing = 0.7;           // of the speed, lost shortly before it stops to turn
constexpr double kStraightMisfit = 0.3;    // with more to turn, it rather makes room for turning
constexpr double kCellMarginM = 0.01;      // a cell's middle lies before the surface that raised it
constexpr double kEchoMarginM = 0.03;      // an echo's noise; more keeps it out of doors
constexpr double kLeastTurnRad = 1e-3;     // a step that turns less does nothing
constexpr double kNearM = 0.8;             // what may be touched in one step or a few
constexpr double kCloseEchoM = 0.5;        // nearly where a cone's axis says
constexpr std::size_t kRememberedSweeps = 8;    // of close echoes: the last second or so
constexpr std::size_t kRememberedSteps = 1000;  // that can be taken back; bounds memory
constexpr int kWayOutSteps = 40;  // of creeping that are looked ahead for a place to turn

/// The point of the way some distance ahead of the way's point nearest to the robot.
Point2 look_ahead(const Polyline& way, const Point2& position) {
  const auto nearest = std::min_element(way.begin(), way.end(), [&](const auto& a, const auto& b) {
    return (a - position).squaredNorm() < (b - position).squaredNorm();
  });
  double length_m = 0.0;
  auto at = nearest;
  for (; std::next(at) != way.end() && length_m < kLookAheadM; ++at) {
    length_m += (*std::next(at) - *at).norm();
  }
  return *at;
}

/// The direction near `wanted_rad` with low values of k.
double open_direction(const ExplorerMap& map, const Point2& position, double wanted_rad) {
  const std::vector<double> k = polar_histogram(map.himm(), position, {kSectorDeg, kWindowM});
  const int count = static_cast<int>(k.size());
  const int spread = static_cast<int>(kMaxDeviationDeg / kSectorDeg);
  const auto density = [&](double bearing_rad) {
    const int middle = static_cast<int>(std::floor(degrees(bearing_rad) / kSectorDeg));
    double sum = 0.0;
    for (int i = middle - 1; i <= middle + 1; ++i) {
      sum += k[static_cast<std::size_t>(((i % count) + count) % count)];
    }
    return sum / 3.0;
  };
  double best_rad = wanted_rad;
  double least = std::numeric_limits<double>::infinity();
  for (int i = -spread; i <= spread; ++i) {
    const double bearing_rad = wanted_rad + radians(i * kSectorDeg);
    const double cost =
        std::abs(i) * kSectorDeg / kMaxDeviationDeg + density(bearing_rad) / kDensityOfWall;
    if (cost >= least) continue;
    least = cost;
    best_rad = bearing_rad;
  }
  return best_rad;
}

/// What stands around the robot, against which its steps are checked.
class Surroundings {
 public:
  Surroundings(const ExplorerMap& map, const std::vector<Point2>& echoes_map,
               const Pose2& map_from_robot, const RobotFootprint& footprint)
      : cells_(map.obstacles_within(map_from_robot.position(), kNearM)),
        echoes_(echoes_map),
        half_size_(footprint.length_m / 2.0, footprint.width_m / 2.0) {}

  /// Whether a step ends clear of obstacles, or at least clearer than it began: less of them
  /// inside the robot's margins, and none deeper than the deepest was.
  [[nodiscard]] bool allow(const Pose2& map_from_robot, const Steering& step) const {
    const Intrusion there = intrusion(after(map_from_robot, step));
    if (there.sum_m == 0.0) return true;
    const Intrusion here = intrusion(map_from_robot);
    return there.sum_m < here.sum_m && there.deepest_m <= here.deepest_m;
  }

  [[nodiscard]] static Pose2 after(const Pose2& map_from_robot, const Steering& step) {
    return map_from_robot * Pose2{0.0, 0.0, step.turn_rad} * Pose2{step.length_m, 0.0, 0.0};
  }

 private:
  /// How deep obstacles stand inside the robot's rectangle and its margins.
  struct Intrusion {
    double sum_m = 0.0;
    double deepest_m = 0.0;
  };
  [[nodiscard]] Intrusion intrusion(const Pose2& map_from_robot) const {
    const Pose2 robot_from_map = inverse(map_from_robot);
    Intrusion found;
    const auto add = [&](const std::vector<Point2>& obstacles, double margin_m) {
      for (const Point2& obstacle : obstacles) {
        const Point2 inside = half_size_ - (robot_from_map * obstacle).cwiseAbs();
        const double depth_m = std::max(0.0, inside.minCoeff() + margin_m);
        found.sum_m += depth_m;
        found.deepest_m = std::max(found.deepest_m, depth_m);
      }
    };
    add(cells_, kCellMarginM);
    add(echoes_, kEchoMarginM);
    return found;
  }

  std::vector<Point2> cells_;
  std::vector<Point2> echoes_;
  Point2 half_size_;
};

/// The robot cannot turn where it stands: it creeps ahead or back, whichever sooner lets it.
Steering way_out(const Surroundings& around, const Pose2& map_from_robot, double turn_rad,
                 const SteeringLimits& limits) {
  const double creep_m = limits.max_length_m / kCreepSlower;
  std::array<Pose2, 2> at = {map_from_robot, map_from_robot};
  std::array<bool, 2> open = {true, true};
  for (int step = 0; step < kWayOutSteps; ++step) {
    for (const std::size_t back : {0U, 1U}) {
      const Steering creep{0.0, back == 1U ? -creep_m : creep_m};
      open[back] = open[back] && around.allow(at[back], creep);
      if (!open[back]) continue;
      at[back] = Surroundings::after(at[back], creep);
      if (around.allow(at[back], {turn_rad, 0.0})) return creep;
    }
  }
  const Steering other_way{-turn_rad, 0.0};
  return around.allow(map_from_robot, other_way) ? other_way : Steering{};
}

}  // namespace

void Trace::add(const Steering& made) {
  if (made.turn_rad == 0.0 && made.length_m == 0.0) return;
  steps_.push_back(made);
  if (steps_.size() > kRememberedSteps) steps_.pop_front();
}

std::optional<Steering> Trace::take_back() {
  if (steps_.empty()) return std::nullopt;
  const Steering last = steps_.back();
  steps_.pop_back();
  return Steering{-last.turn_rad, -last.length_m, !last.drives_first};
}

void CloseEchoes::add(const RangeReading& reading, const Pose2& map_from_robot) {
  std::vector<Point2> points;
  for (std::size_t i = 0; i < reading.ranges_m.size(); ++i) {
    const double range_m = reading.ranges_m[i];
    if (!(range_m > 0.0) || range_m >= std::min(kCloseEchoM, reading.sensor->max_range_m)) continue;
    points.push_back(map_from_robot * (reading.sensor->robot_from_beam[i] * Point2(range_m, 0.0)));
  }
  sweeps_.push_back(std::move(points));
  if (sweeps_.size() > kRememberedSweeps) sweeps_.pop_front();
}

std::vector<Point2> CloseEchoes::points_map() const {
  std::vector<Point2> points;
  for (const auto& sweep : sweeps_) points.insert(points.end(), sweep.begin(), sweep.end());
  return points;
}

Steering steer(const ExplorerMap& map, const std::vector<Point2>& echoes_map,
               const Pose2& map_from_robot, const RobotFootprint& footprint, const Polyline& way,
               const SteeringLimits& limits) {
  if (way.empty()) return {};
  const Point2 position = map_from_robot.position();
  const Point2 ahead = look_ahead(way, position) - position;
  const double wanted_rad = open_direction(map, position, std::atan2(ahead.y(), ahead.x()));
  const double error_rad = wrap_angle(wanted_rad - map_from_robot.theta_rad);
  const double turn_rad = std::clamp(error_rad, -limits.max_turn_rad, limits.max_turn_rad);
  const double misfit = std::abs(error_rad) / radians(kTurnOnSpotDeg);
  const double length_m = misfit >= 1.0 ? 0.0 : limits.max_length_m * (1.0 - kSlowing * misfit);

  const Surroundings around(map, echoes_map, map_from_robot, footprint);
  const double creep_m = limits.max_length_m / kCreepSlower;
  for (const Steering& step :
       {Steering{turn_rad, length_m}, Steering{turn_rad, length_m / kCreepSlower},
        Steering{turn_rad, 0.0}, Steering{turn_rad / 2.0, creep_m},
        Steering{turn_rad / 4.0, creep_m},
        Steering{0.0, misfit < kStraightMisfit ? length_m / kCreepSlower : 0.0}}) {
    const bool moves = step.length_m != 0.0 || std::abs(step.turn_rad) > kLeastTurnRad;
    if (moves && around.allow(map_from_robot, step)) return step;
  }
  return way_out(around, map_from_robot, turn_rad, limits);
}

Steering shuffle(const ExplorerMap& map, const std::vector<Point2>& echoes_map,
                 const Pose2& map_from_robot, const RobotFootprint& footprint, bool back_first,
                 const SteeringLimits& limits) {
  const Surroundings around(map, echoes_map, map_from_robot, footprint);
  const double length_m = limits.max_length_m / (back_first ? -2.0 : 2.0);
  for (const double step_m : {length_m, -length_m}) {
    if (around.allow(map_from_robot, {0.0, step_m})) return {0.0, step_m};
  }
  return {};
}

}  // namespace roomatlas
