// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/match/scan_odometry.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <deque>
#include <string>
#include <utility>

#include "roomatlas/match/local_map.hpp"
#include "roomatlas/mission/resample.hpp"

namespace roomatlas {
namespace {

constexpr double kLongestStepS = 1.0;  // after a longer silence nobody goes on as before
constexpr double kBareAcross = 20.0;   // points' weight on walls across a direction that holds it

// As for sweeps with odometry: less is below the error of ranges.
constexpr double kStillM = 0.03;
constexpr double kStillRad = radians(1.0);
constexpr double kAnotherTurnRad = radians(0.5);

/// The sweep as if each beam had been measured where the robot was at its first one.
/// @param within how the robot moved from the first beam to the last
std::vector<float> without_motion(const RangeReading& reading, const Pose2& within) {
  const RangeSensor& sensor = *reading.sensor;
  const std::size_t beams = sensor.robot_from_beam.size();
  std::vector<SweepRay> rays(beams);
  for (std::size_t i = 0; i < beams; ++i) {
    const double place = static_cast<double>(i) / std::max(1.0, static_cast<double>(beams) - 1.0);
    const Pose2 moved = interpolate({}, within, reading.sweep_s < 0.0 ? 1.0 - place : place);
    const auto range_m = static_cast<double>(reading.ranges_m[i]);
    const bool is_measured = std::isfinite(range_m) && range_m > 0.0;
    const Pose2& beam = sensor.robot_from_beam[i];
    rays[i].origin = moved * beam.position();
    rays[i].echo = !is_measured                   ? Echo::unknown
                   : range_m < sensor.max_range_m ? Echo::surface
                                                  : Echo::nothing;
    const double end_m = is_measured ? range_m : sensor.max_range_m;
    rays[i].end = moved * (beam * Point2(end_m, 0.0));
  }
  return resampled(rays, sensor);
}

/// The map of the last metres.
class RecentMap {
 public:
  explicit RecentMap(const ScanOdometryOptions& options)
      : options_(options), map_(options.cell_m) {}

  [[nodiscard]] const LocalMap& map() const { return map_; }

  void add_where_new(Scan scan, const Pose2& odom_from_robot) {
    if (!sweeps_.empty()) {
      const Pose2 moved = inverse(sweeps_.back().second) * odom_from_robot;
      const bool is_new = moved.position().norm() > options_.insert_every_m ||
                          std::abs(moved.theta_rad) > radians(options_.insert_every_deg);
      if (!is_new) return;
    }
    map_.add(scan, odom_from_robot);
    sweeps_.emplace_back(std::move(scan), odom_from_robot);
    if (sweeps_.size() >= 2 * static_cast<std::size_t>(options_.kept)) forget();
  }

 private:
  /// Draws the map anew without the older half.
  void forget() {
    sweeps_.erase(sweeps_.begin(), sweeps_.begin() + options_.kept);
    map_ = LocalMap(options_.cell_m);
    for (const auto& [scan, odom_from_robot] : sweeps_) map_.add(scan, odom_from_robot);
  }

  ScanOdometryOptions options_;
  LocalMap map_;
  std::deque<std::pair<Scan, Pose2>> sweeps_;
};

/// Whether the walls that were seen hold both directions of the plane.
bool is_held(const ScanAlignment& aligned) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(aligned.hessian.topLeftCorner<2, 2>(),
                                                              Eigen::EigenvaluesOnly);
  return solver.eigenvalues()(0) > kBareAcross;
}

class ScanOdometry : public MissionSource {
 public:
  ScanOdometry(std::unique_ptr<MissionSource> mission, const ScanOdometryOptions& options)
      : mission_(std::move(mission)), options_(options), recent_(options) {}

  [[nodiscard]] std::optional<MissionEvent> next() override {
    auto event = mission_->next();
    if (event) {
      auto* reading = std::get_if<RangeReading>(&*event);
      if (reading != nullptr && reading->sensor->kind == SensorKind::laser) place(*reading);
    }
    return event;
  }

  [[nodiscard]] const MissionInfo& info() const override {
    info_ = mission_->info();
    info_.odometry = "scan matching";
    info_.path_length_m = path_m_;
    std::string text =
        "there is none: the poses come from matching each sweep with those before it";
    if (bare_ > 0) {
      text += "; in " + std::to_string(100 * bare_ / sweeps_) +
              " % of them walls told nothing of the way along a corridor, which is taken as going "
              "on";
    }
    if (unrolled_ > 0) {
      text += "; " + std::to_string(unrolled_) + " of " + std::to_string(sweeps_) +
              " sweeps were taken while the robot moved: each beam is put to its own pose";
    }
    info_.issues.insert(info_.issues.begin(), {Severity::warning, info_.file, 0, "odometry",
                                               text + ". Record odometry to be sure"});
    return info_;
  }

  [[nodiscard]] double progress() const override { return mission_->progress(); }

 private:
  void place(RangeReading& reading) {
    ++sweeps_;
    const double time_s = reading.timestamp_s;
    if (!last_s_) last_s_ = last_matched_s_ = time_s;
    const Pose2 going = going_on(time_s, told_turn(reading.odom_from_robot.theta_rad));
    const Pose2 guess = odom_from_robot_ * going;
    const bool goes_as_told = options_.turns_are_told && time_s > *last_s_;
    Seen seen = see(reading, goes_as_told ? within_sweep(reading, going, time_s - *last_s_)
                                          : within_sweep(reading, step_, step_s_));
    Matched matched = match(seen.scan, guess);
    if (matched.is_matched && reading.sweep_s != 0.0 && time_s > *last_s_) {
      // the motion that was found tells better than the one before how the robot moved in the sweep
      const Pose2 step = inverse(odom_from_robot_) * matched.odom_from_robot;
      const Pose2 within = within_sweep(reading, step, time_s - *last_s_);
      if (std::abs(within.theta_rad - seen.within.theta_rad) > kAnotherTurnRad) {
        seen = see(reading, within);
        matched = match(seen.scan, guess);
      }
    }
    if (matched.is_bare) ++bare_;
    const Pose2 turned{0.0, 0.0, options_.turns_are_told ? going.theta_rad : 0.0};
    move_on(matched.is_matched ? matched.odom_from_robot : odom_from_robot_ * turned, time_s);
    if (matched.is_matched) {
      last_matched_s_ = time_s;
      if (!seen.scan.points.empty()) recent_.add_where_new(std::move(seen.scan), odom_from_robot_);
    } else if (time_s - *last_matched_s_ > options_.longest_lost_s) {
      throw NotEnoughError(
          mission_->info().file + ": no odometry, and scan matching alone does not hold: from " +
          std::to_string(*last_matched_s_) + " s on the sweeps do not fit those before for " +
          std::to_string(std::lround(options_.longest_lost_s)) +
          " s. The sensor moves too fast, or sees too little; record odometry with the ranges");
    }
    if (!seen.ranges_m.empty()) {
      reading.ranges_m = std::move(seen.ranges_m);
      ++unrolled_;
    }
    reading.sweep_s = 0.0;
    reading.odom_from_robot = odom_from_robot_;
  }

  /// A sweep with each beam put to its own pose.
  struct Seen {
    Scan scan;
    std::vector<float> ranges_m;  ///< empty: as they were measured
    Pose2 within;                 ///< how the robot moved in the sweep
  };
  [[nodiscard]] Seen see(const RangeReading& reading, const Pose2& within) const {
    Seen seen;
    seen.within = within;
    const bool moves = within.position().norm() > kStillM || std::abs(within.theta_rad) > kStillRad;
    if (!moves) {
      seen.scan = scan_of(reading, options_.scan);
      return seen;
    }
    RangeReading unrolled = reading;
    unrolled.ranges_m = seen.ranges_m = without_motion(reading, within);
    seen.scan = scan_of(unrolled, options_.scan);
    return seen;
  }

  /// How far a motion goes on from a sweep's first beam to its last; nowhere where that is not
  /// known, or the last step is too old.
  [[nodiscard]] static Pose2 within_sweep(const RangeReading& reading, const Pose2& step,
                                          double step_s) {
    if (step_s <= 0.0 || step_s > kLongestStepS) return {};
    const double share = std::abs(reading.sweep_s) / step_s;
    return {share * step.x_m, share * step.y_m, share * step.theta_rad};
  }

  struct Matched {
    Pose2 odom_from_robot;
    bool is_matched = false;
    bool is_bare = false;
  };
  [[nodiscard]] Matched match(const Scan& scan, const Pose2& guess) const {
    if (recent_.map().empty()) return {guess, true, false};
    const ScanAlignment aligned = match(thinned(scan.points, options_.max_points), guess);
    if (!is_believed(aligned)) return {guess, false, false};
    return {aligned.map_from_points, true, !is_held(aligned)};
  }

  /// What a gyro says of the time since the last sweep; nothing where there is none.
  [[nodiscard]] std::optional<double> told_turn(double heading_rad) {
    if (!options_.turns_are_told) return std::nullopt;
    const double last_rad = std::exchange(told_heading_, heading_rad).value_or(heading_rad);
    return wrap_angle(heading_rad - last_rad);
  }

  /// What the last step becomes in the time since.
  [[nodiscard]] Pose2 going_on(double time_s, const std::optional<double>& turn_rad) const {
    const double passed_s = time_s - *last_s_;
    if (step_s_ <= 0.0 || passed_s <= 0.0 || passed_s > kLongestStepS) {
      return {0.0, 0.0, turn_rad.value_or(0.0)};
    }
    const double share = std::min(2.0, passed_s / step_s_);
    return {share * step_.x_m, share * step_.y_m,
            turn_rad.value_or(wrap_angle(share * step_.theta_rad))};
  }

  [[nodiscard]] bool is_believed(const ScanAlignment& aligned) const {
    return aligned.matched >= options_.min_matched &&
           aligned.matched >= options_.min_matched_share * aligned.points;
  }

  [[nodiscard]] ScanAlignment match(const std::vector<ScanPoint>& points,
                                    const Pose2& guess) const {
    const PosePrior prior{
        guess, options_.position_sigma_m,
        options_.turns_are_told ? options_.told_sigma_rad : options_.heading_sigma_rad};
    const ScanAlignment near = align(recent_.map(), points, guess, prior, options_.align);
    if (near.matched >= options_.ease_share * near.points) return near;
    const Pose2 start = correlate(recent_.map(), points, prior, options_.correlate);
    const ScanAlignment far = align(recent_.map(), points, start, prior, options_.align);
    return far.matched > near.matched ? far : near;
  }

  void move_on(const Pose2& odom_from_robot, double time_s) {
    const double passed_s = time_s - *last_s_;
    step_ = inverse(odom_from_robot_) * odom_from_robot;
    step_s_ = passed_s;
    path_m_ += step_.position().norm();
    odom_from_robot_ = odom_from_robot;
    last_s_ = time_s;
  }

  std::unique_ptr<MissionSource> mission_;
  ScanOdometryOptions options_;
  RecentMap recent_;
  Pose2 odom_from_robot_;
  Pose2 step_;                          ///< the last one, in the robot's frame ...
  double step_s_ = 0.0;                 ///< ... and how long it took
  std::optional<double> told_heading_;  ///< a gyro's, at the last sweep
  std::optional<double> last_s_;
  std::optional<double> last_matched_s_;
  std::int64_t sweeps_ = 0;
  std::int64_t bare_ = 0;
  std::int64_t unrolled_ = 0;  ///< sweeps of which each beam was put to its own pose
  double path_m_ = 0.0;
  mutable MissionInfo info_;
};

}  // namespace

std::unique_ptr<MissionSource> scan_odometry(std::unique_ptr<MissionSource> mission,
                                             const ScanOdometryOptions& options) {
  return std::make_unique<ScanOdometry>(std::move(mission), options);
}

}  // namespace roomatlas
