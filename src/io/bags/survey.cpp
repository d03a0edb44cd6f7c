// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/survey.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace roomatlas::io {
namespace {

constexpr std::int64_t kEnough_ns = 10'000'000'000;  // where something moved by then
constexpr std::int64_t kMost_ns = 60'000'000'000;
constexpr std::int64_t kMostBytes = std::int64_t{256} << 20;
constexpr std::size_t kMostFrames = 64;
constexpr std::size_t kMostDelays = 101;
constexpr double kMovedM = 0.05;
constexpr double kTurnedRad = radians(3.0);

bool is_laser(MessageKind kind) {
  return kind == MessageKind::laser || kind == MessageKind::echoes;
}

bool is_range(MessageKind kind) {
  return is_laser(kind) || kind == MessageKind::cloud || kind == MessageKind::range;
}

class Surveyor {
 public:
  explicit Surveyor(BagReader& reader) : reader_(reader) {}

  Survey run() {
    meet_topics();
    select();
    while (true) {
      const std::optional<BagMessage> message = reader_.next();
      meet_topics();
      if (!message) break;
      take(*message);
      if (is_enough(*message)) return finished(false);
    }
    return finished(true);
  }

 private:
  void meet_topics() {
    const std::vector<BagTopic>& topics = reader_.topics();
    if (topics.size() == result_.topics.size()) return;  // which it is after nearly all messages
    for (std::size_t i = result_.topics.size(); i < topics.size(); ++i) {
      TopicEvidence evidence;
      const BagTopic& topic = topics[i];
      if (topic.encoding != BagEncoding::other) evidence.kind = kind_of_message(topic.type);
      if (evidence.kind) evidence.misfit = misfit_of(*evidence.kind, topic.type, topic.definition);
      const bool is_empty = topic.messages == 0 || !evidence.misfit.empty();
      has_laser_ = has_laser_ || (evidence.kind && is_laser(*evidence.kind) && !is_empty);
      expects_ranges_ = expects_ranges_ || (evidence.kind && is_range(*evidence.kind) && !is_empty);
      result_.evidence.push_back(std::move(evidence));
    }
    result_.topics = topics;
  }

  /// Clouds are large: they are looked at where there is no laser.
  void select() {
    std::vector<std::size_t> wanted;
    for (std::size_t i = 0; i < result_.topics.size(); ++i) {
      const TopicEvidence& evidence = result_.evidence[i];
      const bool is_read = evidence.kind && evidence.misfit.empty();
      if (is_read && !(has_laser_ && *evidence.kind == MessageKind::cloud)) wanted.push_back(i);
    }
    reader_.select(wanted);
  }

  void take(const BagMessage& message) {
    if (message.topic >= result_.evidence.size()) return;
    TopicEvidence& evidence = result_.evidence[message.topic];
    if (!evidence.kind || !evidence.misfit.empty()) return;
    ++evidence.messages;
    bytes_ += static_cast<std::int64_t>(message.bytes.size());
    first_log_ns_ = std::min(first_log_ns_.value_or(message.log_time_ns), message.log_time_ns);
    if (!evidence.first_log_ns) evidence.first_log_ns = message.log_time_ns;
    evidence.last_log_ns = message.log_time_ns;
    const MessageCursor in(message.bytes, result_.topics[message.topic].encoding);
    if (!look_at(evidence, in, message)) {
      ++evidence.unreadable;
    } else if (is_range(*evidence.kind)) {
      has_ranges_ = true;
    }
  }

  bool look_at(TopicEvidence& evidence, const MessageCursor& in, const BagMessage& message) {
    switch (*evidence.kind) {
      case MessageKind::laser:
        return look_at_laser(evidence, read_laser_scan(in), message);
      case MessageKind::echoes:
        return look_at_laser(evidence, read_echoes(in), message);
      case MessageKind::cloud:
        return look_at_cloud(evidence, in, message);
      case MessageKind::odometry:
      case MessageKind::transform:
        return look_at_pose(evidence, read_odometry(in), message);
      case MessageKind::pose:
        return look_at_pose(evidence, read_pose(in), message);
      case MessageKind::transforms:
        return look_at_transforms(evidence, read_transforms(in), message);
      case MessageKind::imu: {
        const auto imu = read_imu(in);
        if (imu && imu->has_gyro) note(evidence, imu->header, message);
        return imu && imu->has_gyro;
      }
      case MessageKind::range:
        break;
    }
    const auto header = read_header(in);
    if (header) note(evidence, *header, message);
    return header.has_value();
  }

  static void note(TopicEvidence& evidence, const HeaderMessage& header,
                   const BagMessage& message) {
    const auto known = std::find(evidence.frames.begin(), evidence.frames.end(), header.frame);
    if (known == evidence.frames.end() && evidence.frames.size() < kMostFrames) {
      evidence.frames.push_back(header.frame);
    }
    if (header.stamp_ns <= 0) {
      ++evidence.without_stamp;
      return;
    }
    if (!evidence.first_stamp_ns) evidence.first_stamp_ns = header.stamp_ns;
    evidence.last_stamp_ns = header.stamp_ns;
    if (evidence.log_minus_stamp_ns.size() < kMostDelays) {
      evidence.log_minus_stamp_ns.push_back(message.log_time_ns - header.stamp_ns);
    }
  }

  bool look_at_laser(TopicEvidence& evidence, const std::optional<LaserScanMessage>& scan,
                     const BagMessage& message) {
    if (!scan) return false;
    note(evidence, scan->header, message);
    const auto steps = static_cast<double>(scan->ranges_m.size());
    evidence.beams = std::max(evidence.beams, scan->ranges_m.size());
    evidence.view_rad = std::max(evidence.view_rad, std::abs(scan->angle_increment_rad) * steps);
    return true;
  }

  static bool look_at_cloud(TopicEvidence& evidence, const MessageCursor& in,
                            const BagMessage& message) {
    constexpr float kFlatM = 0.05F;
    const auto cloud = read_cloud(in);
    if (!cloud || !cloud->has_coordinates) return false;
    note(evidence, cloud->header, message);
    if (evidence.beams > 0 || cloud->points.empty()) return true;
    evidence.beams = cloud->points.size();
    const auto [low, high] = std::minmax_element(
        cloud->points.begin(), cloud->points.end(),
        [](const Eigen::Vector3f& a, const Eigen::Vector3f& b) { return a.z() < b.z(); });
    evidence.is_flat = high->z() - low->z() < kFlatM;
    return true;
  }

  bool look_at_pose(TopicEvidence& evidence, const std::optional<PoseMessage>& pose,
                    const BagMessage& message) {
    if (!pose) return false;
    note(evidence, pose->header, message);
    if (evidence.child_frame.empty()) evidence.child_frame = pose->child_frame;
    if (!pose->frame_from_child) return true;
    if (!evidence.first_pose) evidence.first_pose = pose->frame_from_child;
    const Transform3 moved = inverse(*evidence.first_pose) * *pose->frame_from_child;
    evidence.moved_m = std::max(evidence.moved_m, moved.translation.norm());
    evidence.turned_rad = std::max(evidence.turned_rad,
                                   moved.rotation.angularDistance(Eigen::Quaterniond::Identity()));
    something_moved_ = something_moved_ || evidence.moves();
    return true;
  }

  bool look_at_transforms(TopicEvidence& evidence, const std::optional<TransformsMessage>& message,
                          const BagMessage& raw) {
    if (!message) return false;
    const bool is_fixed = result_.topics[raw.topic].name.ends_with("tf_static");
    for (const PoseMessage& transform : *message) {
      if (!is_fixed) note(evidence, transform.header, raw);
    }
    result_.frames.add(*message, is_fixed);
    return true;
  }

  [[nodiscard]] bool is_enough(const BagMessage& message) const {
    const std::int64_t span_ns = message.log_time_ns - *first_log_ns_;
    if (expects_ranges_ && !has_ranges_) return false;  // a laser that was switched on late
    return bytes_ > kMostBytes || span_ns > kMost_ns || (span_ns > kEnough_ns && something_moved_);
  }

  Survey finished(bool is_whole) {
    result_.is_whole = is_whole;
    result_.topics = reader_.topics();  // with what is known of their counts by now
    std::int64_t from_ns = 0;
    std::int64_t to_ns = 0;
    for (const TopicEvidence& evidence : result_.evidence) {
      if (evidence.kind != MessageKind::transforms || !evidence.first_log_ns) continue;
      if (from_ns == 0 || *evidence.first_log_ns < from_ns) from_ns = *evidence.first_log_ns;
      to_ns = std::max(to_ns, *evidence.last_log_ns);
    }
    const double span_s = seconds(to_ns - from_ns);
    for (const FrameEdge& edge : result_.frames.edges()) {
      if (edge.is_fixed || span_s <= 0.0) continue;
      result_.frame_rate_hz[edge.child] = static_cast<double>(edge.transforms) / span_s;
    }
    return std::move(result_);
  }

  BagReader& reader_;
  Survey result_;
  bool has_laser_ = false;
  bool expects_ranges_ = false;
  bool has_ranges_ = false;
  bool something_moved_ = false;
  std::int64_t bytes_ = 0;
  std::optional<std::int64_t> first_log_ns_;
};

}  // namespace

bool TopicEvidence::moves() const { return moved_m > kMovedM || turned_rad > kTurnedRad; }

double TopicEvidence::rate_hz() const {
  if (messages < 2 || !first_log_ns || *last_log_ns <= *first_log_ns) return 0.0;
  return static_cast<double>(messages - 1) / seconds(*last_log_ns - *first_log_ns);
}

Survey survey(BagReader& reader) { return Surveyor(reader).run(); }

}  // namespace roomatlas::io
