// SPDX-License-Identifier: GPL-3.0-or-later
// What a recording's source tells of the recording.
#include "bags/bag_source.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <sstream>
#include <utility>

namespace roomatlas::io {
namespace {

std::string percent(std::int64_t part, std::int64_t whole) {
  std::ostringstream text;
  text.precision(2);
  text << 100.0 * static_cast<double>(part) / static_cast<double>(whole) << " %";
  return text.str();
}

std::string shown(double value) {
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}

}  // namespace

void BagSource::add_issue(Severity severity, std::string field, std::string message) {
  info_.issues.push_back({severity, info_.file, 0, std::move(field), std::move(message)});
}

void BagSource::describe() {
  static constexpr std::array kUses = {"",         "laser",      "laser", "cloud", "range",
                                       "odometry", "transforms", "truth", "gyro"};
  RecordingInfo recording;
  const double span_s = first_log_ns_ ? seconds(newest_log_ns_ - *first_log_ns_) : 0.0;
  const std::vector<BagTopic>& topics = reader_->topics();
  for (std::size_t i = 0; i < topics.size(); ++i) {
    RecordedTopic topic{topics[i].name, topics[i].type, topics[i].messages, 0.0, {}, ""};
    if (i < topics_.size()) {
      const Topic& used = topics_[i];
      topic.use = kUses[static_cast<std::size_t>(used.use)];
      topic.frames.assign(used.frames.begin(), used.frames.end());
      if (topic.frames.empty()) topic.frames = evidence_[i].frames;
      if (ended_ && used.use != Use::none) topic.messages = used.used + used.unreadable;
      if (used.kind == MessageKind::transforms) topic.frames.clear();  // the tree has them
    }
    const std::int64_t messages = topic.messages.value_or(0);
    if (messages > 1 && span_s > 0.0) topic.rate_hz = static_cast<double>(messages) / span_s;
    recording.topics.push_back(std::move(topic));
  }
  std::sort(recording.topics.begin(), recording.topics.end(),
            [](const RecordedTopic& a, const RecordedTopic& b) { return a.name < b.name; });
  for (const FrameEdge& edge : poses_->frames().edges()) {
    recording.frames.push_back({edge.parent, edge.child, edge.is_fixed, edge.transforms});
  }
  recording.choice = choice_.said;
  recording.base_frame = choice_.base_frame;
  const bool has_odometry = choice_.odometry != TopicChoice::Odometry::none;
  recording.odometry_frame = has_odometry ? choice_.odometry_frame : "";
  if (choice_.gyro) recording.gyro_topic = reader_->topics()[choice_.gyro->topic].name;
  info_.recording = std::move(recording);
}

void BagSource::note_end() {
  describe();
  Issues odd = reader_->issues();
  info_.issues.insert(info_.issues.end(), std::make_move_iterator(odd.begin()),
                      std::make_move_iterator(odd.end()));
  add_issue(Severity::note, "topics", choice_.said);
  for (const Issue& issue : choice_.issues) add_issue(issue.severity, issue.field, issue.message);
  note_unreadable();
  note_poses();
  note_lasers();
}

void BagSource::note_unreadable() {
  std::string nothing_left;
  for (std::size_t i = 0; i < topics_.size(); ++i) {
    const Topic& topic = topics_[i];
    if (topic.unreadable == 0) continue;
    const std::string& name = reader_->topics()[i].name;
    add_issue(Severity::warning, name,
              std::to_string(topic.unreadable) + " of " +
                  std::to_string(topic.used + topic.unreadable) +
                  " messages are left out; of the first: " + topic.why);
    const bool is_scan = topic.use == Use::laser || topic.use == Use::echoes ||
                         topic.use == Use::cloud || topic.use == Use::range;
    if (is_scan && topic.used == 0) nothing_left = name + ": " + topic.why;
  }
  if (info_.readings > 0) return;
  if (!nothing_left.empty()) {
    add_issue(Severity::error, "no range readings", "every message was left out; " + nothing_left);
  } else if (without_pose_ > 0) {
    add_issue(Severity::error, "no range readings",
              "all " + std::to_string(without_pose_) +
                  " readings are at times of which odometry (" + info_.odometry +
                  ") tells nothing; name another by --odom-topic, or map by scan matching alone "
                  "with --odom-topic none");
  }
}

void BagSource::note_poses() {
  const auto warn_of = [&](std::int64_t count, const char* field, const char* what) {
    if (count > 0) add_issue(Severity::warning, field, std::to_string(count) + what);
  };
  if (info_.readings > 0) {
    warn_of(without_pose_, "odometry",
            " readings are left out: odometry tells nothing of their times (no pose within half a "
            "second)");
  }
  if (at_nearest_pose_ > 0) {
    constexpr std::int64_t kFew = 100;  // less than one of so many is the rule at both ends
    add_issue(kFew * at_nearest_pose_ < info_.readings ? Severity::note : Severity::warning,
              "odometry",
              std::to_string(at_nearest_pose_) +
                  " readings are before the first or after the last pose of odometry, or were "
                  "waited for in vain: the nearest pose, at most half a second off, is theirs");
  }
  warn_of(poses_->clock_set_back(), "stamps",
          " times the clock of odometry or tf was set back: what came before is forgotten then");
  warn_of(poses_->steps_without_gyro(), "gyro",
          " steps of odometry keep its own turn: the gyro tells nothing of their times");
  warn_of(without_stamp_, "stamps",
          " messages have a stamp of zero: their time is told from when they were recorded");
  warn_of(poses_->unsound(), "transforms",
          " poses are left out: numbers that are not finite, no unit quaternion, no frame, or "
          "one more than 10000 frames");
  warn_of(poses_->frames().parents_changed(), "transforms",
          " times a frame got another parent: two programs tell where it is, and tf holds the "
          "newer");
  warn_of(group_.missing(), "lasers",
          " times a laser of the group had no sweep within half a period of the first one's");
  warn_of(
      group_.left_out(), "lasers",
      " sweeps of further lasers are left out: none of the first one's is within half a period, "
      "or another is nearer");
  warn_of(ring_.strangers(), "sonars",
          " readings of sonars that were not heard at the recording's beginning are left out");
  if (poses_->out_of_order() > 0) {
    add_issue(Severity::note, "stamps",
              std::to_string(poses_->out_of_order()) + " poses came out of order and were sorted");
  }
  if (!unjoined_truth_.empty()) {
    add_issue(Severity::note, "truth",
              "its poses are of " + unjoined_truth_ + ", which no tf joins to " +
                  choice_.base_frame + ": taken for the robot's");
  }
  if (poses_->took_base_frames_for_one()) {
    add_issue(Severity::note, "frames",
              "no tf joins base_link and base_footprint: taken for one, as they differ in height "
              "alone");
  }
}

void BagSource::note_lasers() {
  const LaserNotes& notes = lasers_.notes();
  const EchoCounts& echoes = notes.echoes;
  const std::int64_t none = echoes.invalid + echoes.too_near + echoes.too_far;
  if (none > 0) {
    add_issue(Severity::note, "ranges",
              percent(none, echoes.beams) + " of the beams are no reading: " +
                  percent(echoes.invalid, echoes.beams) + " NaN, -Inf or 0, " +
                  percent(echoes.too_near, echoes.beams) + " below range_min, " +
                  percent(echoes.too_far, echoes.beams) + " beyond range_max; " +
                  percent(echoes.nothing, echoes.beams) + " met nothing within range");
  }
  if (notes.unrolled > 0) {
    add_issue(Severity::note, "sweeps",
              std::to_string(notes.unrolled) + " of " + std::to_string(notes.sweeps) +
                  " were taken while the robot moved: each beam is put to its own pose");
  }
  if (clouds_.unrolled() > 0) {
    add_issue(Severity::note, "clouds",
              std::to_string(clouds_.unrolled()) + " of " + std::to_string(clouds_.clouds()) +
                  " were taken while the robot moved: each point is put to its own pose");
  }
  if (notes.keeps_changing) {
    add_issue(Severity::note, "sweeps",
              "the laser's beams or place keep changing: further sweeps are resampled onto its "
              "first beams");
  }
  if (notes.is_upside_down) {
    add_issue(Severity::note, "mount", "the laser hangs upside down: its bearings are mirrored");
  }
  constexpr double kTiltToTellRad = radians(2.0);
  if (notes.most_tilt_rad > kTiltToTellRad) {
    add_issue(Severity::warning, "mount",
              "the laser is tilted by up to " + shown(degrees(notes.most_tilt_rad)) +
                  " degrees: ranges are taken as seen from above, but far ones meet floor or "
                  "ceiling");
  }
  if (clouds_.points() > 0) {
    const RecordingOptions& recording = options_.recording;
    const bool is_flat = evidence_[choice_.scans.front()].is_flat;
    const std::string band = is_flat
                                 ? "they lie in one plane"
                                 : "those from " + shown(recording.cloud_low_m) + " to " +
                                       shown(recording.cloud_high_m) + " m above the plane of " +
                                       choice_.base_frame + " (--cloud-low, --cloud-high)";
    add_issue(Severity::note, "cloud",
              percent(clouds_.points_taken(), clouds_.points()) +
                  " of its points are taken, the nearest of each bearing: " + band);
  }
}

}  // namespace roomatlas::io
