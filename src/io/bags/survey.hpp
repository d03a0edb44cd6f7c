// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/bag_reader.hpp"
#include "bags/frame_tree.hpp"
#include "bags/messages.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace roomatlas::io {

/// What the beginning of a recording shows of one topic.
struct TopicEvidence {
  std::optional<MessageKind> kind;  ///< none: nothing that is read
  std::string misfit;               ///< why its messages are not what its type says; else empty
  std::int64_t messages = 0;        ///< seen
  std::int64_t unreadable = 0;      ///< of these
  std::int64_t without_stamp = 0;   ///< of these
  std::vector<std::string> frames;  ///< of headers, in order of appearance; the first 64
  std::string child_frame;          ///< of odometry, the first
  std::optional<std::int64_t> first_log_ns, last_log_ns;
  std::optional<std::int64_t> first_stamp_ns, last_stamp_ns;
  std::vector<std::int64_t> log_minus_stamp_ns;  ///< of the first hundred
  double view_rad = 0.0;                         ///< of a laser
  std::size_t beams = 0;                         ///< of a laser; points of a cloud
  bool is_flat = false;  ///< of a cloud: all its points lie in one plane of its own frame
  std::optional<Transform3> first_pose;
  double moved_m = 0.0;  ///< farthest from the first pose
  double turned_rad = 0.0;

  [[nodiscard]] bool moves() const;
  /// Messages a second, by log times; 0 where there are too few.
  [[nodiscard]] double rate_hz() const;
};

/// What the beginning of a recording shows.
struct Survey {
  std::vector<BagTopic> topics;
  std::vector<TopicEvidence> evidence;  ///< one a topic
  FrameTree frames;
  std::map<std::string, double> frame_rate_hz;  ///< of moving edges, by the child's name
  bool is_whole = false;                        ///< the recording was read to its end
};

/// Reads a recording until it is known which topics can be mapped: some seconds, or up to a minute
/// where nothing moves.
[[nodiscard]] Survey survey(BagReader& reader);

}  // namespace roomatlas::io
