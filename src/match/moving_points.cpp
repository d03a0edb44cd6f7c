// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/match/moving_points.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "range_profile.hpp"

namespace roomatlas {
namespace {

using Place = RangeProfile::Place;

struct EarlierSweep {
  double timestamp_s = 0.0;
  Pose2 then_from_now;  ///< of the robot
  std::vector<Point2> hits;
  RangeProfile profile;
};

/// Of the robot at one sweep.
struct Poses {
  Pose2 odom_from_robot;
  Pose2 map_from_robot;
};

/// What the sweeps before tell of a point.
struct Told {
  int moves = 0;
  int was_there = 0;
};

EarlierSweep sweep_of(const Scan& scan, double timestamp_s) {
  std::vector<Point2> hits;
  for (const ScanPoint& point : scan.points) {
    if (point.is_hit) hits.push_back(point.position);
  }
  const RangeProfile profile(scan.sensor, hits);
  return {timestamp_s, Pose2{}, std::move(hits), profile};
}

/// Adds what one sweep tells of each point of the scan.
void tell(const EarlierSweep& then, const Scan& scan, const RangeProfile& now,
          const RangeProfile::Tolerance& tolerance, std::vector<Told>& told) {
  std::array<bool, RangeProfile::kBins> is_gone{};  // what stood there
  const PointTransform now_from_then(inverse(then.then_from_now));
  for (const Point2& hit : then.hits) {
    const bool is_looked_through = now.place_of(now_from_then * hit, tolerance) == Place::through;
    if (!is_looked_through) continue;
    const std::size_t bin = then.profile.bin_of(hit);  // and beside it, as in the profile
    for (const std::size_t off : {RangeProfile::kBins - 1, std::size_t{0}, std::size_t{1}}) {
      is_gone[(bin + off) % RangeProfile::kBins] = true;
    }
  }
  const PointTransform then_from_now(then.then_from_now);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    if (!scan.points[i].is_hit) continue;
    const Point2 at = then_from_now * scan.points[i].position;
    const Place place = then.profile.place_of(at, tolerance);
    if (place == Place::there) ++told[i].was_there;
    if (place == Place::through || (place == Place::behind && is_gone[then.profile.bin_of(at)])) {
      ++told[i].moves;
    }
  }
}

/// The points of things that move and are narrow enough.
std::vector<std::size_t> points_of_things(const Scan& scan, const std::vector<Told>& told,
                                          const MovingPointsOptions& options) {
  std::vector<std::size_t> found;
  std::vector<std::size_t> thing;
  const auto apart_m = [&](std::size_t a, std::size_t b) {
    return (scan.points[a].position - scan.points[b].position).norm();
  };
  const auto end_thing = [&] {
    const bool is_seen_well = static_cast<int>(thing.size()) >= std::max(1, options.min_points);
    if (is_seen_well && apart_m(thing.front(), thing.back()) <= options.widest_m) {
      found.insert(found.end(), thing.begin(), thing.end());
    }
    thing.clear();
  };
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    if (!scan.points[i].is_hit) continue;
    const bool moves = told[i].moves >= options.min_sweeps &&
                       told[i].was_there <= options.most_there * told[i].moves;
    if (!moves || (!thing.empty() && apart_m(thing.back(), i) > options.gap_m)) end_thing();
    if (moves) thing.push_back(i);
  }
  end_thing();
  return found;
}

}  // namespace

struct MovingPoints::State {
  explicit State(const MovingPointsOptions& given) : options(given) {}

  void remember(EarlierSweep sweep) {
    if (!sweeps.empty()) {
      const double passed_s = sweep.timestamp_s - sweeps.back().timestamp_s;
      if (passed_s >= 0.0 && passed_s < options.apart_s) return;
    }
    sweeps.push_back(std::move(sweep));
    if (sweeps.size() > static_cast<std::size_t>(options.kept)) sweeps.pop_front();
  }

  /// The step since the sweep before.
  [[nodiscard]] Pose2 step_to(const Poses& now) {
    const Poses before = std::exchange(last, now).value_or(now);
    Pose2 told = inverse(before.odom_from_robot) * now.odom_from_robot;
    const Pose2 found = inverse(before.map_from_robot) * now.map_from_robot;
    if ((told.position() - found.position()).norm() > options.slip_m) return found;
    told.theta_rad = found.theta_rad;
    return told;
  }

  MovingPointsOptions options;
  std::optional<Poses> last;
  std::deque<EarlierSweep> sweeps;
};

MovingPoints::MovingPoints(const MovingPointsOptions& options)
    : state_(std::make_unique<State>(options)) {}
MovingPoints::~MovingPoints() = default;
MovingPoints::MovingPoints(MovingPoints&&) noexcept = default;
MovingPoints& MovingPoints::operator=(MovingPoints&&) noexcept = default;

void MovingPoints::clear() {
  state_->sweeps.clear();
  state_->last.reset();
}

int MovingPoints::hide(Scan& scan, double timestamp_s, const Pose2& odom_from_robot,
                       const Pose2& map_from_robot) {
  const Pose2 step = state_->step_to({odom_from_robot, map_from_robot});
  const MovingPointsOptions& options = state_->options;
  EarlierSweep now = sweep_of(scan, timestamp_s);
  std::vector<Told> told(scan.points.size());
  for (EarlierSweep& then : state_->sweeps) {
    then.then_from_now = then.then_from_now * step;
    tell(then, scan, now.profile, {options.tolerance_m, options.tolerance_share}, told);
  }
  const std::vector<std::size_t> moving = points_of_things(scan, told, options);
  const auto most = options.most_share * static_cast<double>(now.hits.size());
  state_->remember(std::move(now));
  if (static_cast<double>(moving.size()) > most) return 0;
  for (const std::size_t i : moving) scan.points[i].is_hit = false;
  return static_cast<int>(moving.size());
}

}  // namespace roomatlas
