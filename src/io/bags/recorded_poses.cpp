// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/recorded_poses.hpp"

#include "bags/robot_poses.hpp"
#include "bags/survey.hpp"
#include "bags/topic_choice.hpp"

#include "roomatlas/io/text/utf8.hpp"

#include <algorithm>
#include <utility>

namespace roomatlas::io {
namespace {

/// A recording whose beginning has been surveyed.
struct Recording {
  std::filesystem::path path;
  std::string name;
  Survey beginning;
};

Recording open(const std::filesystem::path& path) {
  return {path, as_utf8(path.filename().string()), survey(*open_bag(path))};
}

/// The topic of poses with the most messages for which that holds.
template <typename Holds>
std::optional<std::size_t> find_topic(const Survey& beginning, Holds holds) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < beginning.topics.size(); ++i) {
    if (!has_poses(beginning.evidence[i]) || !holds(i)) continue;
    if (!best || beginning.evidence[i].messages > beginning.evidence[*best].messages) best = i;
  }
  return best;
}

/// The robot's frames as tf has them; no root where nothing is above odometry's.
struct TfFrames {
  std::string root;
  std::string odometry;
  std::string base;
};
TfFrames frames_of(const Recording& recording, RecordingOptions options) {
  options.odometry_topic = "";
  TopicChoice choice;
  choose_odometry(choice, recording.beginning, options, recording.name);
  const auto above = recording.beginning.frames.edges_above(choice.base_frame);
  return {above.empty() ? "" : above.back().parent, choice.odometry_frame, choice.base_frame};
}

std::vector<std::size_t> transforms_of(const Survey& beginning) {
  std::vector<std::size_t> topics;
  for (std::size_t i = 0; i < beginning.topics.size(); ++i) {
    const TopicEvidence& evidence = beginning.evidence[i];
    const bool is_tf = evidence.kind == MessageKind::transforms && evidence.misfit.empty();
    if (is_tf) topics.push_back(i);
  }
  return topics;
}

/// From poses of what was observed to poses of the robot, on which it sits.
class RobotIn {
 public:
  RobotIn(const Survey& beginning, std::string base)
      : beginning_(beginning), base_(std::move(base)) {
    frames_.add_fixed_of(beginning.frames);
  }
  void add(const TransformsMessage& transforms, bool is_fixed) {
    frames_.add(transforms, is_fixed);
  }
  [[nodiscard]] Transform3 operator()(const PoseMessage& pose) {
    const std::string& child = pose.child_frame;
    if (child.empty() || child == base_) return *pose.frame_from_child;
    const std::int64_t stamp_ns = pose.header.stamp_ns;
    auto child_from_base = frames_.lookup(child, base_, stamp_ns, Constant::holds_always);
    if (!child_from_base) {  // a mount that is told later than its first poses
      child_from_base = beginning_.frames.lookup(child, base_, stamp_ns, Constant::holds_always);
    }
    if (child_from_base) return *pose.frame_from_child * child_from_base->transform;
    const bool differ_in_height = is_usual_base(child) && is_usual_base(base_);
    if (!differ_in_height) unjoined_ = child;
    return *pose.frame_from_child;
  }
  /// What no tf joins to the robot; empty where all were joined.
  [[nodiscard]] const std::string& unjoined() const { return unjoined_; }
  [[nodiscard]] const std::string& base() const { return base_; }

 private:
  const Survey& beginning_;
  std::string base_;
  FrameTree frames_;
  std::string unjoined_;
};

/// The poses of a topic, of the robot as far as tf tells how.
/// @param must_join by which option a topic was named whose poses are to be the robot's; else null
RecordedPoses read_topic(const Recording& recording, std::size_t topic,
                         const RecordingOptions& options, const char* must_join = nullptr) {
  const auto reader = open_bag(recording.path);
  const BagTopic& of = recording.beginning.topics[topic];
  const bool is_pose = recording.beginning.evidence[topic].kind == MessageKind::pose;
  RecordedPoses read{of.name + " of " + reader->format(), {}, {}};
  RobotIn robot_in(recording.beginning, frames_of(recording, options).base);
  std::vector<std::size_t> wanted = {topic};
  if (!is_pose) {
    const std::vector<std::size_t> transforms = transforms_of(recording.beginning);
    wanted.insert(wanted.end(), transforms.begin(), transforms.end());
  }
  reader->select(wanted);
  std::int64_t left_out = 0;
  while (const auto message = reader->next()) {
    const BagTopic& from = recording.beginning.topics[message->topic];
    const MessageCursor in(message->bytes, from.encoding);
    if (message->topic != topic) {
      const auto transforms = read_transforms(in);
      if (transforms) robot_in.add(*transforms, from.name.ends_with("tf_static"));
      continue;
    }
    const auto pose = is_pose ? read_pose(in) : read_odometry(in);
    if (!pose || !pose->frame_from_child) {
      ++left_out;
      continue;
    }
    const std::int64_t stamp_ns = pose->header.stamp_ns;
    read.poses.push_back(
        {seconds(stamp_ns > 0 ? stamp_ns : message->log_time_ns), planar(robot_in(*pose))});
  }
  read.issues = reader->issues();
  if (left_out > 0) {
    read.issues.push_back({Severity::warning, recording.name, 0, of.name,
                           std::to_string(left_out) + " poses that cannot be read are left out"});
  }
  if (robot_in.unjoined().empty()) return read;
  const std::string why = "its poses are of " + robot_in.unjoined() + ", which no tf joins to " +
                          robot_in.base() + ", the robot's frame";
  if (must_join != nullptr) {
    throw InputError(recording.name + ": " + must_join + " " + of.name + ": " + why +
                     "; where they are the robot's all the same, say --base-frame " +
                     robot_in.unjoined());
  }
  read.issues.push_back(
      {Severity::warning, recording.name, 0, of.name, why + ": taken for the robot's"});
  return read;
}

/// The robot in a frame of tf, at each transform that is the last on the way to it.
RecordedPoses read_tf(const Recording& recording, const std::string& root,
                      const std::string& base) {
  const auto reader = open_bag(recording.path);
  RecordedPoses read{"tf " + root + " -> " + base + " of " + reader->format(), {}, {}};
  reader->select(transforms_of(recording.beginning));
  std::string moving = base;  // the lowest edge that is no mount
  for (const FrameEdge& edge : recording.beginning.frames.edges_above(base)) {
    if (edge.is_fixed) continue;
    moving = edge.child;
    break;
  }
  FrameTree frames;
  frames.add_fixed_of(recording.beginning.frames);
  while (const auto message = reader->next()) {
    const BagTopic& topic = recording.beginning.topics[message->topic];
    const auto transforms = read_transforms({message->bytes, topic.encoding});
    if (!transforms) continue;
    frames.add(*transforms, topic.name.ends_with("tf_static"));
    for (const PoseMessage& transform : *transforms) {
      if (transform.child_frame != moving) continue;
      const std::int64_t stamp_ns = transform.header.stamp_ns;
      const auto root_from_odom = frames.newest(root, transform.header.frame);
      const auto pose =
          frames.lookup(transform.header.frame, base, stamp_ns, Constant::holds_always);
      if (!root_from_odom || !pose) continue;
      read.poses.push_back({seconds(stamp_ns), planar(*root_from_odom * pose->transform)});
    }
  }
  read.issues = reader->issues();
  return read;
}

[[noreturn]] void refuse(const Recording& recording, const char* option) {
  throw InputError(recording.path.string() +
                   ": no poses: looked for nav_msgs/Odometry, geometry_msgs/PoseStamped, "
                   "PoseWithCovarianceStamped, TransformStamped and tf; name a topic by " +
                   option);
}

RecordedPoses named(const Recording& recording, const std::string& name, const char* option,
                    const RecordingOptions& options) {
  if (name == "tf" || name == "/tf") {
    const TfFrames frames = frames_of(recording, options);
    const bool is_odometry = std::string(option) == "--odom-topic";
    const std::string& parent = is_odometry ? frames.odometry : frames.root;
    if (parent.empty()) refuse(recording, option);
    return read_tf(recording, parent, frames.base);
  }
  const std::size_t topic = topic_named(recording.beginning, name, option, recording.name);
  if (!has_poses(recording.beginning.evidence[topic])) {
    throw UsageError(recording.name + ": " + option + " " + name + ": has no poses");
  }
  const bool is_truth = std::string(option) == "--truth-topic";
  return read_topic(recording, topic, options, is_truth ? option : nullptr);
}

}  // namespace

RecordedPoses read_recorded_truth(const std::filesystem::path& path,
                                  const RecordingOptions& options) {
  const Recording recording = open(path);
  const Survey& beginning = recording.beginning;
  if (!options.truth_topic.empty()) {
    return named(recording, options.truth_topic, "--truth-topic", options);
  }
  const auto for_truth = find_topic(
      beginning, [&](std::size_t i) { return is_named_for_truth(beginning.topics[i].name); });
  if (for_truth) return read_topic(recording, *for_truth, options);
  const TfFrames frames = frames_of(recording, options);
  if (!frames.root.empty() && frames.root != frames.odometry) {
    return read_tf(recording, frames.root, frames.base);
  }
  const auto of_poses = find_topic(beginning, [&](std::size_t i) {
    return beginning.evidence[i].kind != MessageKind::odometry;
  });
  if (of_poses) return read_topic(recording, *of_poses, options);
  const auto any = find_topic(beginning, [](std::size_t) { return true; });
  if (any) return read_topic(recording, *any, options);
  refuse(recording, "--truth-topic");
}

RecordedPoses read_recorded_poses(const std::filesystem::path& path,
                                  const RecordingOptions& options) {
  const Recording recording = open(path);
  const Survey& beginning = recording.beginning;
  if (!options.odometry_topic.empty()) {
    return named(recording, options.odometry_topic, "--odom-topic", options);
  }
  const auto odometry = find_topic(beginning, [&](std::size_t i) {
    return beginning.evidence[i].kind == MessageKind::odometry;
  });
  if (odometry) return read_topic(recording, *odometry, options);
  const auto any = find_topic(beginning, [](std::size_t) { return true; });
  if (any) return read_topic(recording, *any, options);
  const TfFrames frames = frames_of(recording, options);
  if (!frames.root.empty()) return read_tf(recording, frames.root, frames.base);
  refuse(recording, "--odom-topic");
}

bool is_recording(const std::filesystem::path& path) {
  std::error_code unknown;
  const bool is_file =
      std::filesystem::is_regular_file(path, unknown) && !std::filesystem::is_empty(path, unknown);
  if (!is_file && !std::filesystem::is_directory(path, unknown)) return false;
  if (is_file && is_bag_by_magic(path)) return true;  // opening reads what has no index whole
  return open_bag(path) != nullptr;
}

bool has_ranges(const std::filesystem::path& path) {
  const auto reader = open_bag(path);
  return std::any_of(reader->topics().begin(), reader->topics().end(), [](const BagTopic& topic) {
    const auto kind = kind_of_message(topic.type);
    return kind == MessageKind::laser || kind == MessageKind::echoes ||
           kind == MessageKind::cloud || kind == MessageKind::range;
  });
}

}  // namespace roomatlas::io
