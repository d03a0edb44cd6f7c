// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/topic_choice.hpp"

#include "text/nearest_name.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace roomatlas::io {
namespace {

bool contains_word(std::string text, std::initializer_list<const char*> words) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::any_of(words.begin(), words.end(),
                     [&](const char* word) { return text.find(word) != std::string::npos; });
}

/// Poses in such a frame are a localizer's answer, which jumps, not odometry.
bool is_of_a_map(const std::string& frame) {
  return contains_word(frame, {"map", "world", "earth", "utm"});
}

/// One source of odometry, and what speaks for it.
struct Candidate {
  TopicChoice::Odometry source = TopicChoice::Odometry::none;
  std::size_t topic = 0;
  std::string frame;
  std::string child;
  double rate_hz = 0.0;
  bool moves = false;
  bool covers = false;    ///< it is there while there are scans
  bool is_in_tf = false;  ///< tf tells the same frames: it is the odometry that the robot used
};

/// Seconds of the first scans' times that a topic does not cover.
bool covers_scans(const TopicEvidence& evidence, const TopicChoice& choice, const Survey& survey) {
  constexpr std::int64_t kSlack_ns = 2'000'000'000;
  if (!evidence.first_log_ns) return false;
  for (const auto* list : {&choice.scans, &choice.ranges}) {
    for (const std::size_t i : *list) {
      const TopicEvidence& scans = survey.evidence[i];
      if (!scans.first_log_ns) continue;
      if (*evidence.first_log_ns > *scans.first_log_ns + kSlack_ns ||
          *evidence.last_log_ns < *scans.last_log_ns - kSlack_ns) {
        return false;
      }
    }
  }
  return true;
}

bool tf_has_edge(const Survey& survey, const std::string& parent, const std::string& child) {
  const std::vector<FrameEdge> edges = survey.frames.edges();
  return std::any_of(edges.begin(), edges.end(), [&](const FrameEdge& edge) {
    return edge.parent == parent && edge.child == child && !edge.is_fixed;
  });
}

std::string scan_frame(const TopicChoice& choice, const Survey& survey) {
  for (const auto* list : {&choice.scans, &choice.ranges}) {
    for (const std::size_t i : *list) {
      if (!survey.evidence[i].frames.empty()) return survey.evidence[i].frames.front();
    }
  }
  return "";
}

std::vector<Candidate> topic_candidates(const TopicChoice& choice, const Survey& survey) {
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < survey.topics.size(); ++i) {
    const TopicEvidence& evidence = survey.evidence[i];
    if (evidence.kind != MessageKind::odometry || !evidence.misfit.empty()) continue;
    if (!evidence.first_pose || evidence.frames.empty()) continue;
    if (is_of_a_map(evidence.frames.front())) continue;
    if (is_named_for_truth(survey.topics[i].name)) continue;  // a simulator's, in frame "odom"
    Candidate candidate{TopicChoice::Odometry::topic,
                        i,
                        evidence.frames.front(),
                        evidence.child_frame,
                        evidence.rate_hz(),
                        evidence.moves(),
                        false,
                        false};
    candidate.covers = covers_scans(evidence, choice, survey);
    candidate.is_in_tf = tf_has_edge(survey, candidate.frame, candidate.child);
    candidates.push_back(std::move(candidate));
  }
  return candidates;
}

/// tf's edge that tells the robot's way: on the way up from the laser (or from the base frame), the
/// one below a frame that is named for odometry; else the lowest one that moves and is no map's.
std::optional<Candidate> tf_candidate(const TopicChoice& choice, const Survey& survey,
                                      const RecordingOptions& options) {
  const std::string from =
      options.base_frame.empty() ? scan_frame(choice, survey) : frame_name(options.base_frame);
  std::optional<FrameEdge> found;
  std::vector<FrameEdge> edges = survey.frames.edges_above(from);
  bool joined = !edges.empty();
  if (edges.empty()) edges = survey.frames.edges();  // the laser's mount is not told
  const auto is_odometry = [&](const FrameEdge& edge) {
    return options.odometry_frame.empty() ? contains_word(edge.parent, {"odom"})
                                          : edge.parent == frame_name(options.odometry_frame);
  };
  for (const FrameEdge& edge : edges) {
    if (!edge.is_fixed && !found && is_odometry(edge)) found = edge;
  }
  if (options.odometry_frame.empty()) {
    for (const FrameEdge& edge : edges) {
      if (!found && joined && edge.moves && !edge.is_fixed && !is_of_a_map(edge.parent)) {
        found = edge;
      }
    }
  }
  if (!found) return std::nullopt;
  Candidate candidate{TopicChoice::Odometry::transforms,
                      0,
                      found->parent,
                      found->child,
                      0.0,
                      found->moves,
                      false,
                      true};
  const auto rate = survey.frame_rate_hz.find(found->child);
  if (rate != survey.frame_rate_hz.end()) candidate.rate_hz = rate->second;
  for (const TopicEvidence& evidence : survey.evidence) {
    const bool is_tf = evidence.kind == MessageKind::transforms && evidence.first_stamp_ns;
    candidate.covers = candidate.covers || (is_tf && covers_scans(evidence, choice, survey));
  }
  return candidate;
}

/// Being there, then moving at all, then the rate that a turn needs, then what the robot itself
/// used, then topics, which have no jitter of a tree in them, then the faster, then the first.
bool is_better(const Candidate& a, const Candidate& b) {
  constexpr double kFastEnoughHz = 5.0;
  const auto rank = [&](const Candidate& c) {
    return std::array{c.covers, c.moves, c.rate_hz >= kFastEnoughHz, c.is_in_tf,
                      c.source == TopicChoice::Odometry::topic};
  };
  if (rank(a) != rank(b)) return rank(a) > rank(b);
  constexpr double kFaster = 1.5;
  return a.rate_hz > kFaster * b.rate_hz;
}

void use(TopicChoice& choice, const Candidate& candidate) {
  choice.odometry = candidate.source;
  choice.odometry_topic = candidate.topic;
  choice.odometry_frame = candidate.frame;
  choice.odometry_child = candidate.child;
}

Candidate named_topic(const Survey& survey, const std::string& name, const std::string& file) {
  const std::size_t index = topic_named(survey, name, "--odom-topic", file);
  const TopicEvidence& evidence = survey.evidence[index];
  if (!has_poses(evidence)) {
    throw UsageError(file + ": --odom-topic " + name + " (" + survey.topics[index].type +
                     "): expected nav_msgs/Odometry or a geometry_msgs pose" +
                     (evidence.misfit.empty() ? "" : "; " + evidence.misfit));
  }
  Candidate candidate;
  candidate.source = TopicChoice::Odometry::topic;
  candidate.topic = index;
  candidate.frame = evidence.frames.empty() ? "" : evidence.frames.front();
  candidate.child = evidence.child_frame;
  return candidate;
}

/// An option named a frame that tells no odometry.
[[noreturn]] void refuse_frame(const Survey& survey, const std::string& named,
                               const std::string& file) {
  std::vector<std::string> parents;  // of what can move
  for (const FrameEdge& edge : survey.frames.edges()) {
    if (!edge.is_fixed && !is_of_a_map(edge.parent)) parents.push_back(edge.parent);
  }
  for (const TopicEvidence& evidence : survey.evidence) {
    const bool is_odometry = evidence.kind == MessageKind::odometry && !evidence.frames.empty();
    if (is_odometry) parents.push_back(evidence.frames.front());
  }
  const std::string nearest = nearest_name(frame_name(named), parents);
  throw UsageError(
      file + ": --odom-frame " + named +
      ": neither an odometry topic nor tf tells where the robot is in it" +
      (nearest.empty() ? "; no frame has anything that moves" : "; nearest comes " + nearest));
}

/// A localizer's correction of odometry jumps, whoever asks for it.
void refuse_correction(const Candidate& candidate, const std::string& file) {
  const bool is_correction =
      is_of_a_map(candidate.frame) && contains_word(candidate.child, {"odom"});
  if (!is_correction) return;
  throw UsageError(file + ": --odom-frame " + candidate.frame + ": tf's " + candidate.frame +
                   " -> " + candidate.child +
                   " is a localizer's answer, which is no odometry; to compare with it: "
                   "--truth-topic tf");
}

std::optional<Candidate> choose(const TopicChoice& choice, const Survey& survey,
                                const RecordingOptions& options, const std::string& file) {
  const std::string& wanted = options.odometry_topic;
  if (wanted == "none") return std::nullopt;
  const auto in_tf = tf_candidate(choice, survey, options);
  if (in_tf) refuse_correction(*in_tf, file);
  if (wanted == "tf" || wanted == "/tf") {
    if (in_tf) return in_tf;
    throw UsageError(file + ": --odom-topic tf: no frame above the laser's moves" +
                     (options.odometry_frame.empty() ? "; name its parent by --odom-frame"
                                                     : " below " + options.odometry_frame));
  }
  if (!wanted.empty()) return named_topic(survey, wanted, file);
  std::optional<Candidate> best = in_tf;
  for (const Candidate& candidate : topic_candidates(choice, survey)) {
    const std::string frame = frame_name(options.odometry_frame);
    if (!frame.empty() && candidate.frame != frame) continue;
    if (!best || is_better(candidate, *best)) best = candidate;
  }
  if (!best && !options.odometry_frame.empty()) refuse_frame(survey, options.odometry_frame, file);
  return best;
}

/// The robot's frame where nothing names it: below odometry, by its usual names, or the laser's.
std::string base_of(const TopicChoice& choice, const Survey& survey) {
  if (!choice.odometry_child.empty()) return choice.odometry_child;
  const std::vector<FrameEdge> edges = survey.frames.edges();
  for (const FrameEdge& edge : edges) {
    if (!edge.is_fixed && !choice.odometry_frame.empty() && edge.parent == choice.odometry_frame) {
      return edge.child;
    }
  }
  const std::string laser = scan_frame(choice, survey);
  for (const char* name : {"base_footprint", "base_link"}) {
    if (laser == name || survey.frames.are_joined(name, laser)) return name;
  }
  return laser.empty() ? "base_link" : laser;
}

}  // namespace

void choose_odometry(TopicChoice& choice, const Survey& survey, const RecordingOptions& options,
                     const std::string& file) {
  if (const auto best = choose(choice, survey, options, file)) use(choice, *best);
  choice.base_frame =
      options.base_frame.empty() ? base_of(choice, survey) : frame_name(options.base_frame);
  if (choice.odometry_child.empty()) choice.odometry_child = choice.base_frame;
}

}  // namespace roomatlas::io
