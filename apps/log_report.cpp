// SPDX-License-Identifier: GPL-3.0-or-later
#include "log_report.hpp"
#include "printable.hpp"
#include "roomatlas/core/counted.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace roomatlas::apps {
namespace {

constexpr std::size_t kMostTopics = 200;  // in the table; `--json` has all
constexpr int kDeepest = 64;

void print_topic(const RecordedTopic& topic, std::size_t name_width, std::size_t type_width) {
  const std::string messages = topic.messages ? fmt::format("{}", *topic.messages) : "?";
  const std::string rate = topic.rate_hz > 0.0 ? fmt::format("{:.1f} Hz", topic.rate_hz) : "";
  say("  {:<{}}  {:<{}}  {:>8}  {:>10}  {:<10}  {}\n", topic.name, name_width, topic.type,
      type_width, messages, rate, topic.use, fmt::format("{}", fmt::join(topic.frames, " ")));
}

void print_topics(const std::vector<RecordedTopic>& topics) {
  std::size_t name_width = 0;
  std::size_t type_width = 0;
  for (const RecordedTopic& topic : topics) {
    name_width = std::max(name_width, topic.name.size());
    type_width = std::max(type_width, topic.type.size());
  }
  say("topics\n");
  for (std::size_t i = 0; i < std::min(topics.size(), kMostTopics); ++i) {
    print_topic(topics[i], name_width, type_width);
  }
  if (topics.size() > kMostTopics) {
    say("  ... and {} more; --json has them\n", topics.size() - kMostTopics);
  }
}

/// A frame's children, indented below it.
void print_below(const std::vector<RecordedFrame>& frames, const std::string& parent, int depth) {
  if (depth > kDeepest) return;
  for (const RecordedFrame& frame : frames) {
    if (frame.parent != parent) continue;
    const std::string how = frame.is_fixed ? "fixed" : counted(frame.transforms, "transform");
    say("  {:{}}{}  ({})\n", "", 2 * depth, frame.child, how);
    print_below(frames, frame.child, depth + 1);
  }
}

void print_frames(const std::vector<RecordedFrame>& frames) {
  std::set<std::string> roots;
  for (const RecordedFrame& frame : frames) roots.insert(frame.parent);
  for (const RecordedFrame& frame : frames) roots.erase(frame.child);
  say("frames\n");
  for (const std::string& root : roots) {
    say("  {}\n", root);
    print_below(frames, root, 1);
  }
}

}  // namespace

void print(const RecordingInfo& recording) {
  print_topics(recording.topics);
  if (!recording.frames.empty()) print_frames(recording.frames);
  say("mapped         {}\n", recording.choice);
}

}  // namespace roomatlas::apps
