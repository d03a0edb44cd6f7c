// SPDX-License-Identifier: GPL-3.0-or-later
#include "topic_table.hpp"

#include <algorithm>
#include <utility>

namespace roomatlas::io {
namespace {

constexpr std::size_t kMostDefinitions_bytes = std::size_t{1} << 26;  // of all topics together

}  // namespace

std::string plain_type(std::string_view type) {
  std::vector<std::string> parts(1);
  for (std::size_t i = 0; i < type.size(); ++i) {
    const bool is_pair = type.substr(i, 2) == "::";
    if (type[i] == '/' || is_pair) {
      parts.emplace_back();
      i += is_pair ? 1 : 0;
    } else {
      parts.back() += type[i];
    }
  }
  if (parts.size() < 3 || parts[1] != "msg") return std::string(type);
  const bool is_dds = parts.size() == 4 && parts[2] == "dds_" && parts[3].ends_with('_');
  if (is_dds) parts[3].pop_back();
  if (parts.size() > 3 && !is_dds) return std::string(type);
  return parts.front() + "/" + parts.back();
}

BagEncoding bag_encoding_of(std::string_view name) {
  if (name == "cdr") return BagEncoding::cdr;
  return name == "ros1" ? BagEncoding::ros1 : BagEncoding::other;
}

std::optional<std::size_t> TopicTable::add(BagTopic topic) {
  std::string key = topic.name + '\0' + topic.type + '\0';
  key += std::to_string(static_cast<int>(topic.encoding));
  const auto known = index_.find(key);
  if (known != index_.end()) {
    BagTopic& there = topics_[known->second];
    if (there.definition.empty()) there.definition = std::move(topic.definition);
    return known->second;
  }
  if (topics_.size() >= kMostTopics) {
    ++left_out_;
    return std::nullopt;
  }
  definition_bytes_ += topic.definition.size();
  if (definition_bytes_ > kMostDefinitions_bytes) topic.definition = {};
  topics_.push_back(std::move(topic));
  return index_.emplace(std::move(key), topics_.size() - 1).first->second;
}

void TopicTable::connect(std::uint32_t connection, BagTopic topic) {
  if (topic_of_.contains(connection)) return;
  const auto index = add(std::move(topic));
  if (!index && topic_of_.size() >= 2 * kMostTopics) return;
  topic_of_.emplace(connection, index ? static_cast<std::uint32_t>(*index) : kLeftOut);
}

std::optional<std::size_t> TopicTable::topic_of(std::uint32_t connection) const {
  const auto found = topic_of_.find(connection);
  if (found == topic_of_.end() || found->second == kLeftOut) return std::nullopt;
  return found->second;
}

bool TopicTable::knows(std::uint32_t connection) const { return topic_of_.contains(connection); }

void TopicTable::count(std::uint32_t connection, std::int64_t messages) {
  const auto topic = topic_of(connection);
  if (!topic) return;
  std::optional<std::int64_t>& count = topics_[*topic].messages;
  count = count.value_or(0) + messages;
}

void TopicTable::recount(const std::map<std::uint16_t, std::uint64_t>& messages) {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 53;  // a damaged number is no number
  for (BagTopic& topic : topics_) topic.messages = 0;
  for (const auto& [channel, number] : messages) {
    count(channel, static_cast<std::int64_t>(std::min(number, kMost)));
  }
}

void TopicTable::forget_counts() {
  for (BagTopic& topic : topics_) topic.messages.reset();
}

}  // namespace roomatlas::io
