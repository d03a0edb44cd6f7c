// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/topic_choice.hpp"

#include <algorithm>
#include <array>

namespace roomatlas::io {

bool is_named_for_truth(const std::string& topic) {
  static constexpr std::array kNames = {"truth", "mocap", "vicon", "optitrack", "leica"};
  return std::any_of(kNames.begin(), kNames.end(),
                     [&](const char* name) { return topic.find(name) != std::string::npos; });
}

bool has_poses(const TopicEvidence& evidence) {
  const bool is_kind = evidence.kind == MessageKind::odometry ||
                       evidence.kind == MessageKind::pose ||
                       evidence.kind == MessageKind::transform;
  return is_kind && evidence.misfit.empty();
}

std::size_t usable_topic(const Survey& survey, const std::string& name, const char* option,
                         const std::string& file) {
  const std::size_t index = topic_named(survey, name, option, file);
  const TopicEvidence& evidence = survey.evidence[index];
  if (!evidence.misfit.empty()) {
    throw InputError(file + ": " + name + ": its messages are not what their type says: " +
                     evidence.misfit + "; name another topic by " + option);
  }
  return index;
}

namespace {

/// The topic that its name says is truth; none where several do.
std::optional<std::size_t> named_for_truth(const Survey& survey) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < survey.topics.size(); ++i) {
    const TopicEvidence& evidence = survey.evidence[i];
    if (!is_named_for_truth(survey.topics[i].name) || !has_poses(evidence)) continue;
    if (evidence.messages == evidence.unreadable) continue;
    if (found) return std::nullopt;
    found = i;
  }
  return found;
}

}  // namespace

void choose_truth(TopicChoice& choice, const Survey& survey, const RecordingOptions& options,
                  const std::string& file) {
  if (options.truth_topic == "none") return;
  if (options.truth_topic.empty()) {
    choice.truth = named_for_truth(survey);
    return;
  }
  if (options.truth_topic == "tf" || options.truth_topic == "/tf") {
    const std::vector<FrameEdge> above = survey.frames.edges_above(choice.base_frame);
    if (above.empty()) {
      throw UsageError(file + ": --truth-topic tf: nothing is above the frame " +
                       choice.base_frame + " in tf");
    }
    choice.truth_frame = above.back().parent;
    return;
  }
  const std::size_t index = usable_topic(survey, options.truth_topic, "--truth-topic", file);
  if (!has_poses(survey.evidence[index])) {
    throw UsageError(file + ": --truth-topic " + survey.topics[index].name + " (" +
                     survey.topics[index].type +
                     "): expected nav_msgs/Odometry, geometry_msgs/PoseStamped, "
                     "PoseWithCovarianceStamped or TransformStamped, or tf");
  }
  choice.truth = index;
}

}  // namespace roomatlas::io
