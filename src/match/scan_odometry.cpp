// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/match/scan_odometry.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <deque>
#include <string>
#include <utility>

#include "roomatlas/match/local_map.hpp"

namespace roomatlas {
namespace {

constexpr double kLongestStepS = 1.0;  // after a longer silence nobody goes on as before
constexpr double kBareAcross = 20.0;   // points' weight on walls across a direction that holds it

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
    info_.issues.insert(info_.issues.begin(), {Severity::warning, info_.file, 0, "odometry",
                                               text + ". Record odometry to be sure"});
    return info_;
  }

  [[nodiscard]] double progress() const override { return mission_->progress(); }

 private:
  void place(RangeReading& reading) {
    ++sweeps_;
    Scan scan = scan_of(reading, options_.scan);
    const double time_s = reading.timestamp_s;
    if (!last_s_) last_s_ = last_matched_s_ = time_s;
    const Pose2 guess = odom_from_robot_ * going_on(time_s);
    Pose2 found = guess;
    bool is_matched = recent_.map().empty();
    if (!recent_.map().empty()) {
      const ScanAlignment aligned = match(thinned(scan.points, options_.max_points), guess);
      is_matched = is_believed(aligned);
      if (is_matched) found = aligned.map_from_points;
      if (is_matched && !is_held(aligned)) ++bare_;
    }
    move_on(is_matched ? found : odom_from_robot_, time_s);
    if (is_matched) {
      last_matched_s_ = time_s;
      if (!scan.points.empty()) recent_.add_where_new(std::move(scan), odom_from_robot_);
    } else if (time_s - *last_matched_s_ > options_.longest_lost_s) {
      throw NotEnoughError(
          mission_->info().file + ": no odometry, and scan matching alone does not hold: from " +
          std::to_string(*last_matched_s_) + " s on the sweeps do not fit those before for " +
          std::to_string(std::lround(options_.longest_lost_s)) +
          " s. The sensor moves too fast, or sees too little; record odometry with the ranges");
    }
    reading.odom_from_robot = odom_from_robot_;
  }

  /// What the last step becomes in the time since.
  [[nodiscard]] Pose2 going_on(double time_s) const {
    const double passed_s = time_s - *last_s_;
    if (step_s_ <= 0.0 || passed_s <= 0.0 || passed_s > kLongestStepS) return {};
    const double share = std::min(2.0, passed_s / step_s_);
    return {share * step_.x_m, share * step_.y_m, wrap_angle(share * step_.theta_rad)};
  }

  [[nodiscard]] bool is_believed(const ScanAlignment& aligned) const {
    return aligned.matched >= options_.min_matched &&
           aligned.matched >= options_.min_matched_share * aligned.points;
  }

  [[nodiscard]] ScanAlignment match(const std::vector<ScanPoint>& points,
                                    const Pose2& guess) const {
    const PosePrior prior{guess, options_.position_sigma_m, options_.heading_sigma_rad};
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
  Pose2 step_;           ///< the last one, in the robot's frame ...
  double step_s_ = 0.0;  ///< ... and how long it took
  std::optional<double> last_s_;
  std::optional<double> last_matched_s_;
  std::int64_t sweeps_ = 0;
  std::int64_t bare_ = 0;
  double path_m_ = 0.0;
  mutable MissionInfo info_;
};

}  // namespace

std::unique_ptr<MissionSource> scan_odometry(std::unique_ptr<MissionSource> mission,
                                             const ScanOdometryOptions& options) {
  return std::make_unique<ScanOdometry>(std::move(mission), options);
}

}  // namespace roomatlas
