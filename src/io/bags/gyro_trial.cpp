// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/gyro_trial.hpp"

#include "bags/gyro_evidence.hpp"

#include "roomatlas/match/follow_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace roomatlas::io {
namespace {

constexpr double kLeastRateHz = 10.0;     // a slower gyro misses turns
constexpr std::size_t kMostGyros = 8;     // that are judged
constexpr int kEnoughTurns = 30;          // then the trial ends
constexpr std::size_t kMostSweeps = 256;  // that wait for a gyro

// A stretch ends where the turn does, so that clocks that differ a little do not matter.
constexpr double kTurnedRad = radians(20.0);
constexpr double kSlowRadPerS = radians(3.0);
constexpr double kLongestS = 5.0;
constexpr double kStillS = 1.0;  // one without motion
constexpr double kStillM = 0.01;
constexpr double kStillRad = radians(0.5);

std::int64_t stamp_of(double time_s) { return std::llround(1e9 * time_s); }

/// Cuts what sweeps, odometry and gyros say of the same time into stretches.
class Trial {
 public:
  Trial(const BagSource& mission, const std::vector<std::size_t>& gyros)
      : mission_(mission), gyros_(gyros), stretches_(gyros.size()) {}

  /// False where there is enough.
  bool take(const FollowedSweep& sweep) {
    waiting_.push_back(sweep);
    while (!waiting_.empty() && (is_told(waiting_.front()) || waiting_.size() > kMostSweeps)) {
      step_to(waiting_.front());
      waiting_.pop_front();
    }
    return turns_ < kEnoughTurns;
  }
  void finish() {
    for (const FollowedSweep& sweep : waiting_) step_to(sweep);
    waiting_.clear();
  }
  [[nodiscard]] const std::vector<TurnedStretch>& of(std::size_t gyro) const {
    return stretches_[gyro];
  }

 private:
  struct Stretch {
    double passed_s = 0.0;
    double by_sweeps_rad = 0.0;
    double by_odometry_rad = 0.0;
    double turned_rad = 0.0;  ///< left and right add up, by who says more
    double way_m = 0.0;
    std::vector<std::optional<Eigen::Vector3d>> by_gyros_rad;
  };

  [[nodiscard]] bool is_told(const FollowedSweep& sweep) const {
    return std::all_of(gyros_.begin(), gyros_.end(), [&](std::size_t topic) {
      const auto newest_ns = mission_.gyro(topic).newest_ns();
      return newest_ns && *newest_ns >= stamp_of(sweep.timestamp_s);
    });
  }

  void step_to(const FollowedSweep& sweep) {
    const auto before = std::exchange(last_, sweep);
    const bool follows = before && sweep.goes_on && sweep.timestamp_s > before->timestamp_s;
    if (!follows) {
      begin();
      return;
    }
    const Pose2 by_odometry = inverse(before->odom_from_robot) * sweep.odom_from_robot;
    const Pose2 by_sweeps = inverse(before->matched_from_robot) * sweep.matched_from_robot;
    const double passed_s = sweep.timestamp_s - before->timestamp_s;
    stretch_.passed_s += passed_s;
    stretch_.by_sweeps_rad += by_sweeps.theta_rad;
    stretch_.by_odometry_rad += by_odometry.theta_rad;
    stretch_.turned_rad += std::max(std::abs(by_sweeps.theta_rad), std::abs(by_odometry.theta_rad));
    stretch_.way_m += by_odometry.position().norm();
    for (std::size_t i = 0; i < gyros_.size(); ++i) {
      auto& sum = stretch_.by_gyros_rad[i];
      const auto turn =
          mission_.gyro(gyros_[i]).turn(stamp_of(before->timestamp_s), stamp_of(sweep.timestamp_s));
      sum = sum && turn ? std::optional<Eigen::Vector3d>(*sum + *turn) : std::nullopt;
    }
    end_where_due(std::abs(by_sweeps.theta_rad) / passed_s);
  }

  void begin() {
    stretch_ = {};
    stretch_.by_gyros_rad.assign(gyros_.size(), Eigen::Vector3d(Eigen::Vector3d::Zero()));
  }

  void end_where_due(double rad_per_s) {
    const bool is_still = std::abs(stretch_.by_sweeps_rad) < kStillRad &&
                          std::abs(stretch_.by_odometry_rad) < kStillRad &&
                          stretch_.way_m < kStillM;
    const bool has_turned = std::abs(stretch_.by_sweeps_rad) > kTurnedRad;
    const bool ends = (is_still && stretch_.passed_s > kStillS) ||
                      (has_turned && rad_per_s < kSlowRadPerS) || stretch_.passed_s > kLongestS;
    if (!ends) return;
    for (std::size_t i = 0; i < gyros_.size(); ++i) {
      if (!stretch_.by_gyros_rad[i]) continue;
      stretches_[i].push_back({stretch_.passed_s, stretch_.by_sweeps_rad, stretch_.by_odometry_rad,
                               *stretch_.by_gyros_rad[i], is_still});
    }
    if (has_turned) ++turns_;
    begin();
  }

  const BagSource& mission_;
  const std::vector<std::size_t>& gyros_;
  std::vector<std::vector<TurnedStretch>> stretches_;  ///< of each gyro
  std::deque<FollowedSweep> waiting_;                  ///< for the gyros
  std::optional<FollowedSweep> last_;
  Stretch stretch_;
  int turns_ = 0;
};

struct Judged {
  std::size_t topic = 0;
  GyroVerdict verdict;
};

std::vector<Judged> judge(const TopicChoice& choice, const Survey& beginning,
                          const OpenRecording& open, const MissionOptions& options,
                          const std::string& file) {
  BagSource mission(file, open(), options, choice, beginning);
  Trial trial(mission, choice.gyros);
  try {
    follow_sweeps(mission, {}, [&](const FollowedSweep& sweep) { return trial.take(sweep); });
  } catch (const std::runtime_error&) {  // who maps it will say it
  }
  trial.finish();
  std::vector<Judged> judged;
  for (std::size_t i = 0; i < choice.gyros.size(); ++i) {
    std::optional<Eigen::Vector3d> up;
    if (const auto mount = mission.mount_of_gyro(choice.gyros[i])) {
      up = mount->rotation.conjugate() * Eigen::Vector3d::UnitZ();
    }
    judged.push_back({choice.gyros[i], judge_gyro(trial.of(i), up)});
  }
  return judged;
}

std::string shown_deg(double angle_rad) {
  std::ostringstream text;
  text.precision(2);
  text << degrees(angle_rad);
  return text.str();
}

/// The nearest to the sweeps; of those without turns the first.
const Judged& best_of(const std::vector<Judged>& judged) {
  return *std::min_element(judged.begin(), judged.end(), [](const Judged& a, const Judged& b) {
    if (a.verdict.is_enough != b.verdict.is_enough) return a.verdict.is_enough;
    return a.verdict.gyro_off_rad < b.verdict.gyro_off_rad;
  });
}

std::string line_of(const Judged& best, const std::string& name, bool is_taken, bool is_named,
                    bool has_odometry) {
  const GyroVerdict& found = best.verdict;
  std::string text = is_taken       ? ", turns of the gyro " + name
                     : has_odometry ? ", turns of odometry"
                                    : ", turns by matching";
  if (is_named) text += " as told";
  if (!found.is_enough) {
    return text + (is_taken ? " (unproved: " : " (") + "too few turns with sweeps to judge " +
           (is_taken ? "it" : "the gyro " + name) + " by)";
  }
  const std::string gyro = shown_deg(found.gyro_off_rad);
  const std::string turns = " degrees rms in " + std::to_string(found.stretches) + " turns";
  if (!has_odometry) {
    return text + (is_taken ? " (off the sweeps' by " : " (the gyro " + name + " is off by ") +
           gyro + turns + ")";
  }
  const std::string odometry = shown_deg(found.odometry_off_rad);
  return text + " (off the sweeps' by " + (is_taken ? gyro : odometry) + turns + ", " +
         (is_taken ? "odometry's by " + odometry : "the gyro's of " + name + " by " + gyro) + ")";
}

}  // namespace

void find_gyros(TopicChoice& choice, const Survey& survey, const RecordingOptions& options,
                const std::string& file) {
  if (options.imu_topic == "none") return;
  if (!options.imu_topic.empty()) {
    const std::size_t index = usable_topic(survey, options.imu_topic, "--imu-topic", file);
    if (survey.evidence[index].kind != MessageKind::imu) {
      throw UsageError(file + ": --imu-topic " + survey.topics[index].name + " (" +
                       survey.topics[index].type + "): expected sensor_msgs/Imu");
    }
    choice.gyros = {index};
    return;
  }
  if (choice.scans.empty()) return;
  for (std::size_t i = 0; i < survey.topics.size() && choice.gyros.size() < kMostGyros; ++i) {
    const TopicEvidence& evidence = survey.evidence[i];
    const bool is_usable = evidence.kind == MessageKind::imu && evidence.misfit.empty() &&
                           evidence.messages > evidence.unreadable;
    if (is_usable && evidence.rate_hz() >= kLeastRateHz) choice.gyros.push_back(i);
  }
}

void choose_gyro(TopicChoice& choice, const Survey& beginning, const OpenRecording& open,
                 const MissionOptions& options, const std::string& file) {
  if (choice.gyros.empty()) return;
  const std::vector<Judged> judged = judge(choice, beginning, open, options, file);
  const Judged& best = best_of(judged);
  const bool is_named = !options.recording.imu_topic.empty();
  const bool is_taken = is_named || best.verdict.gyro_is_better;
  if (is_taken) choice.gyro = {best.topic, best.verdict.up, best.verdict.drift_rad_per_s};
  choice.gyros.clear();
  choice.said += line_of(best, beginning.topics[best.topic].name, is_taken, is_named,
                         choice.odometry != TopicChoice::Odometry::none);
}

}  // namespace roomatlas::io
