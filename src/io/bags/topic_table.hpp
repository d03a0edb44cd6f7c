// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bag_reader.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace roomatlas::io {

/// "sensor_msgs/LaserScan" of "sensor_msgs/msg/LaserScan" and of
/// "sensor_msgs::msg::dds_::LaserScan_".
[[nodiscard]] std::string plain_type(std::string_view type);

/// By the name that a recording gives it: "cdr", "ros1".
[[nodiscard]] BagEncoding bag_encoding_of(std::string_view name);

/// The topics of a recording, and which connection or channel is which topic.
class TopicTable {
 public:
  /// More are left out: a robot has hundreds, a damaged file any number.
  static constexpr std::size_t kMostTopics = std::size_t{1} << 18;  // some 80 MB

  /// The topic's index: a known one where name, type and encoding are the same. Nothing when there
  /// are too many.
  std::optional<std::size_t> add(BagTopic topic);
  /// Says which topic a connection carries; a connection that is known already stays as it is.
  void connect(std::uint32_t connection, BagTopic topic);

  [[nodiscard]] std::optional<std::size_t> topic_of(std::uint32_t connection) const;
  [[nodiscard]] bool knows(std::uint32_t connection) const;
  /// Adds to what an index says about the number of messages.
  void count(std::uint32_t connection, std::int64_t messages);
  /// Replaces all counts by these, of channels.
  void recount(const std::map<std::uint16_t, std::uint64_t>& messages);
  void set_count(std::size_t topic, std::optional<std::int64_t> messages) {
    topics_.at(topic).messages = messages;
  }
  void forget_counts();
  [[nodiscard]] const std::vector<BagTopic>& topics() const { return topics_; }
  [[nodiscard]] std::int64_t left_out() const { return left_out_; }

 private:
  static constexpr std::uint32_t kLeftOut = ~std::uint32_t{0};

  std::vector<BagTopic> topics_;
  std::unordered_map<std::string, std::size_t> index_;
  std::unordered_map<std::uint32_t, std::uint32_t> topic_of_;
  std::size_t definition_bytes_ = 0;
  std::int64_t left_out_ = 0;
};

}  // namespace roomatlas::io
