// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/bag_source.hpp"
#include "io/bags/message_bytes.hpp"
#include "io/mission_log.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace roomatlas::test {

/// A recording that a test writes message by message; no container.
class MemoryBag {
 public:
  explicit MemoryBag(Layout of_messages = Layout::ros1) : layout(of_messages) {}

  MemoryBag& add(const std::string& topic, const std::string& type, double log_s,
                 std::vector<std::byte> bytes) {
    const auto known = std::find_if(topics.begin(), topics.end(),
                                    [&](const io::BagTopic& t) { return t.name == topic; });
    const auto index = static_cast<std::size_t>(known - topics.begin());
    if (known == topics.end()) topics.push_back({topic, type, encoding_of(layout), "", 0});
    topics[index].messages = *topics[index].messages + 1;
    messages.push_back({index, std::llround(log_s * 1e9), std::move(bytes)});
    return *this;
  }
  MemoryBag& scan(double log_s, ScanFields fields, const std::string& topic = "/scan") {
    if (fields.stamp_s == 0.0) fields.stamp_s = log_s;
    return add(topic, "sensor_msgs/LaserScan", log_s, scan_bytes(fields, layout));
  }
  MemoryBag& odometry(double log_s, const Pose2& pose, const std::string& topic = "/odom",
                      const std::string& frame = "odom") {
    return add(topic, "nav_msgs/Odometry", log_s,
               odometry_bytes(log_s, pose, frame, "base_link", layout));
  }
  MemoryBag& tf(double log_s, const std::vector<TransformFields>& transforms,
                const std::string& topic = "/tf") {
    return add(topic, "tf2_msgs/TFMessage", log_s, tf_bytes(log_s, transforms, layout));
  }

  struct Message {
    std::size_t topic;
    std::int64_t log_ns;
    std::vector<std::byte> bytes;
  };
  Layout layout;
  std::vector<io::BagTopic> topics;
  std::vector<Message> messages;
};

/// Plays one back in the order of the times of recording.
class MemoryReader : public io::BagReader {
 public:
  explicit MemoryReader(MemoryBag bag) : bag_(std::move(bag)) {
    std::stable_sort(bag_.messages.begin(), bag_.messages.end(),
                     [](const auto& a, const auto& b) { return a.log_ns < b.log_ns; });
  }
  [[nodiscard]] const std::string& format() const override { return format_; }
  [[nodiscard]] const std::vector<io::BagTopic>& topics() const override { return bag_.topics; }
  void select(const std::vector<std::size_t>& topics) override { selected_ = topics; }
  [[nodiscard]] std::optional<io::BagMessage> next() override {
    while (at_ < bag_.messages.size()) {
      const MemoryBag::Message& message = bag_.messages[at_++];
      if (std::count(selected_.begin(), selected_.end(), message.topic) == 0) continue;
      return io::BagMessage{message.topic, message.log_ns, message.bytes};
    }
    return std::nullopt;
  }
  [[nodiscard]] Issues issues() const override { return {}; }
  [[nodiscard]] double progress() const override {
    return static_cast<double>(at_) / static_cast<double>(bag_.messages.size());
  }

 private:
  MemoryBag bag_;
  std::string format_ = "memory";
  std::vector<std::size_t> selected_;
  std::size_t at_ = 0;
};

inline ReadLog read_bag(const MemoryBag& bag, const MissionOptions& options = {}) {
  return read_all(std::make_unique<io::BagSource>(
      "mission.bag", [bag] { return std::make_unique<MemoryReader>(bag); }, options));
}

/// True where an issue's text has these words.
inline bool is_told(const ReadLog& log, const std::string& words) {
  return std::any_of(log.info.issues.begin(), log.info.issues.end(), [&](const Issue& issue) {
    return to_string(issue).find(words) != std::string::npos;
  });
}

}  // namespace roomatlas::test
