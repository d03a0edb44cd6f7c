// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/topic_choice.hpp"

#include "text/nearest_name.hpp"

#include "roomatlas/core/median.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace roomatlas::io {
namespace {

bool is_usable(const TopicEvidence& evidence) {
  return evidence.kind && evidence.misfit.empty() && evidence.messages > evidence.unreadable;
}

bool is_scan(const TopicEvidence& evidence) {
  return evidence.kind &&
         (*evidence.kind == MessageKind::laser || *evidence.kind == MessageKind::echoes ||
          *evidence.kind == MessageKind::cloud);
}

/// Lasers before flat clouds before others: what measures the plane itself is better.
int rank_of(const TopicEvidence& evidence) {
  switch (*evidence.kind) {
    case MessageKind::laser:
      return 3;
    case MessageKind::echoes:
      return 2;
    default:
      return evidence.is_flat ? 1 : 0;
  }
}

/// The widest view wins; of equals what comes oftener, then the shorter name ("/scan", not
/// "/scan_filtered").
std::optional<std::size_t> best_scan(const Survey& survey) {
  std::optional<std::size_t> best;
  const auto is_better = [&](std::size_t one, std::size_t other) {
    const TopicEvidence& a = survey.evidence[one];
    const TopicEvidence& b = survey.evidence[other];
    if (rank_of(a) != rank_of(b)) return rank_of(a) > rank_of(b);
    constexpr double kWiderRad = radians(10.0);
    if (std::abs(a.view_rad - b.view_rad) > kWiderRad) return a.view_rad > b.view_rad;
    constexpr double kOftener = 1.5;
    if (a.rate_hz() > kOftener * b.rate_hz()) return true;
    if (b.rate_hz() > kOftener * a.rate_hz()) return false;
    const std::string& name_a = survey.topics[one].name;
    const std::string& name_b = survey.topics[other].name;
    return std::pair(name_a.size(), name_a) < std::pair(name_b.size(), name_b);
  };
  for (std::size_t i = 0; i < survey.evidence.size(); ++i) {
    const TopicEvidence& evidence = survey.evidence[i];
    if (!is_usable(evidence) || !is_scan(evidence) || evidence.beams == 0) continue;
    if (!best || is_better(i, *best)) best = i;
  }
  return best;
}

std::string shown(const BagTopic& topic) { return topic.name + " (" + topic.type + ")"; }

/// Topics whose type sounds as if a laser or poses were in it, with what speaks against them.
std::string nearest_topics(const Survey& survey) {
  constexpr int kMostNamed = 5;
  std::string text;
  int named = 0;
  for (std::size_t i = 0; i < survey.topics.size() && named < kMostNamed; ++i) {
    const TopicEvidence& evidence = survey.evidence[i];
    const BagTopic& topic = survey.topics[i];
    const bool sounds_like = is_scan(evidence) || topic.type.find("aser") != std::string::npos ||
                             topic.type.find("can") != std::string::npos ||
                             topic.type.find("Cloud") != std::string::npos ||
                             topic.type.find("Depth") != std::string::npos ||
                             topic.type.find("Range") != std::string::npos;
    if (!sounds_like) continue;
    std::string why = "its type is not read";
    if (evidence.kind) why = "no message was seen";
    if (evidence.unreadable > 0) why = "its messages are too short for their type";
    if (!evidence.misfit.empty()) why = evidence.misfit;
    if (topic.encoding == BagEncoding::other) why = "its encoding is not read";
    text += (text.empty() ? "" : "; ") + shown(topic) + ": " + why;
    ++named;
  }
  if (!text.empty()) return "; nearest come " + text;
  if (survey.topics.empty()) return "; there are no topics at all";
  for (const BagTopic& topic : survey.topics) {
    if (named++ >= kMostNamed) break;
    text += (text.empty() ? "" : ", ") + shown(topic);
  }
  return "; it has " + std::to_string(survey.topics.size()) + " topics, such as " + text;
}

void add_once(std::vector<std::size_t>& topics, std::size_t topic) {
  if (std::count(topics.begin(), topics.end(), topic) == 0) topics.push_back(topic);
}

/// All sonars, as long as a robot can have so many: each reading is looked up among them.
void take_sonars(TopicChoice& choice, const Survey& survey) {
  constexpr std::size_t kMostSonars = 256;
  std::int64_t left_out = 0;
  for (std::size_t i = 0; i < survey.evidence.size(); ++i) {
    const TopicEvidence& evidence = survey.evidence[i];
    if (!is_usable(evidence) || evidence.kind != MessageKind::range) continue;
    if (choice.ranges.size() < kMostSonars) {
      choice.ranges.push_back(i);
    } else {
      ++left_out;
    }
  }
  if (left_out == 0) return;
  choice.issues.push_back(
      {Severity::warning, "", 0, "sonars",
       std::to_string(left_out) + " topics of sensor_msgs/Range are left out: " + "more than " +
           std::to_string(kMostSonars) + " are no robot's; --range-topics names others"});
}

void choose_scans(TopicChoice& choice, const Survey& survey, const RecordingOptions& options,
                  const std::string& file) {
  for (const std::string& name : names_in(options.scan_topics)) {
    const std::size_t index = usable_topic(survey, name, "--scan-topic", file);
    if (!is_scan(survey.evidence[index])) {
      throw UsageError(file + ": --scan-topic " + shown(survey.topics[index]) +
                       ": expected sensor_msgs/LaserScan, MultiEchoLaserScan or PointCloud2");
    }
    add_once(choice.scans, index);
  }
  for (const std::string& name : names_in(options.range_topics)) {
    const std::size_t index = usable_topic(survey, name, "--range-topics", file);
    if (survey.evidence[index].kind != MessageKind::range) {
      throw UsageError(file + ": --range-topics " + shown(survey.topics[index]) +
                       ": expected sensor_msgs/Range");
    }
    add_once(choice.ranges, index);
  }
  if (!choice.scans.empty() || !choice.ranges.empty()) return;
  if (const auto best = best_scan(survey)) {
    choice.scans.push_back(*best);
    return;
  }
  take_sonars(choice, survey);
  if (!choice.ranges.empty()) return;
  throw NotEnoughError(file +
                       ": no topic with ranges: looked for sensor_msgs/LaserScan, "
                       "MultiEchoLaserScan, PointCloud2 and Range" +
                       nearest_topics(survey));
}

/// Lasers that are not mapped, so that nobody has to wonder.
void name_others(TopicChoice& choice, const Survey& survey) {
  std::string others;
  for (std::size_t i = 0; i < survey.evidence.size(); ++i) {
    const TopicEvidence& evidence = survey.evidence[i];
    const bool is_taken = std::count(choice.scans.begin(), choice.scans.end(), i) > 0;
    if (is_taken || !is_scan(evidence) || evidence.kind == MessageKind::cloud) continue;
    if (is_usable(evidence)) others += (others.empty() ? "" : ", ") + survey.topics[i].name;
  }
  if (others.empty()) return;
  choice.issues.push_back({Severity::note, "", 0, "scan topics",
                           "not mapped: " + others + "; --scan-topic takes others, or several"});
}

void note_misfits(TopicChoice& choice, const Survey& survey) {
  for (std::size_t i = 0; i < survey.topics.size(); ++i) {
    const TopicEvidence& evidence = survey.evidence[i];
    if (evidence.misfit.empty()) continue;
    choice.issues.push_back({Severity::warning, "", 0, survey.topics[i].name,
                             "is not used: its definition of " + survey.topics[i].type +
                                 " is another: " + evidence.misfit});
  }
}

/// Stamps hold where they are there and all of one clock.
void choose_times(TopicChoice& choice, const Survey& survey) {
  constexpr std::int64_t kApart_ns = 1'000'000'000;
  std::vector<std::size_t> used = choice.scans;
  used.insert(used.end(), choice.ranges.begin(), choice.ranges.end());
  if (choice.odometry == TopicChoice::Odometry::topic) used.push_back(choice.odometry_topic);
  for (std::size_t i = 0; i < survey.evidence.size(); ++i) {
    const bool is_odometry = choice.odometry == TopicChoice::Odometry::transforms;
    if (is_odometry && survey.evidence[i].kind == MessageKind::transforms) used.push_back(i);
  }
  std::optional<std::int64_t> least_ns;
  std::optional<std::int64_t> most_ns;
  for (const std::size_t i : used) {
    const TopicEvidence& evidence = survey.evidence[i];
    if (2 * evidence.without_stamp > evidence.messages) {
      choice.use_log_times = true;
      choice.issues.push_back({Severity::warning, "", 0, survey.topics[i].name,
                               "its stamps are zero: the times of recording are used for all "
                               "topics, which come later by what the way to the recorder took"});
      return;
    }
    if (evidence.log_minus_stamp_ns.empty()) continue;
    const std::int64_t delay_ns = median(evidence.log_minus_stamp_ns);
    if (!least_ns) choice.log_minus_stamp_ns = delay_ns;
    least_ns = std::min(least_ns.value_or(delay_ns), delay_ns);
    most_ns = std::max(most_ns.value_or(delay_ns), delay_ns);
  }
  if (!least_ns || *most_ns - *least_ns <= kApart_ns) return;
  choice.use_log_times = true;
  std::ostringstream text;
  text.precision(3);
  text << "the stamps of scans and odometry are of clocks that differ by "
       << seconds(*most_ns - *least_ns) << " s: the times of recording are used instead";
  choice.issues.push_back({Severity::warning, "", 0, "stamps", text.str()});
}

std::string line_of(const TopicChoice& choice, const Survey& survey) {
  std::string text;
  const auto add = [&](std::size_t i) {
    text += (text.empty() ? "" : " + ") + survey.topics[i].name;
  };
  for (const std::size_t i : choice.scans) add(i);
  for (const std::size_t i : choice.ranges) add(i);
  if (choice.is_one_reading) text += " as one reading";
  switch (choice.odometry) {
    case TopicChoice::Odometry::topic:
      text += ", odometry of " + survey.topics[choice.odometry_topic].name;
      break;
    case TopicChoice::Odometry::transforms:
      text += ", odometry of tf " + choice.odometry_frame + " -> " + choice.odometry_child;
      break;
    case TopicChoice::Odometry::none:
      text += ", no odometry: by scan matching alone";
      break;
  }
  text += ", robot " + choice.base_frame;
  if (choice.truth) text += ", truth of " + survey.topics[*choice.truth].name;
  if (!choice.truth_frame.empty()) {
    text += ", truth of tf " + choice.truth_frame + " -> " + choice.base_frame;
  }
  return text;
}

}  // namespace

std::vector<std::string> names_in(const std::string& list) {
  std::vector<std::string> names;
  std::istringstream parts(list);
  for (std::string name; std::getline(parts, name, ',');) {
    name.erase(0, name.find_first_not_of(' '));
    name.erase(name.find_last_not_of(' ') + 1);
    if (!name.empty()) names.push_back(name);
  }
  return names;
}

std::size_t topic_named(const Survey& survey, const std::string& name, const char* option,
                        const std::string& file) {
  constexpr std::size_t kMostNamed = 20;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < survey.topics.size(); ++i) {
    const std::string& topic = survey.topics[i].name;
    if (frame_name(topic) == frame_name(name)) return i;
    if (names.empty() || names.back() != topic) names.push_back(topic);
  }
  const std::string nearest = nearest_name(name, names);
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  std::string all;
  for (std::size_t i = 0; i < std::min(names.size(), kMostNamed); ++i) {
    all += (i == 0 ? "" : ", ") + names[i];
  }
  if (names.size() > kMostNamed) all += " ...";
  throw UsageError(file + ": " + option + " " + name + ": no such topic; nearest comes " + nearest +
                   "; there are " + all);
}

TopicChoice choose_topics(const Survey& survey, const RecordingOptions& options,
                          const std::string& file) {
  TopicChoice choice;
  note_misfits(choice, survey);
  choose_scans(choice, survey, options, file);
  choose_odometry(choice, survey, options, file);
  join_lasers(choice, survey, options);
  name_others(choice, survey);
  find_gyros(choice, survey, options, file);
  choose_truth(choice, survey, options, file);
  choose_times(choice, survey);
  choice.said = line_of(choice, survey);
  return choice;
}

}  // namespace roomatlas::io
