// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/bag_reader.hpp"

#include <compare>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

namespace roomatlas::test::bags {

struct Message {
  std::string topic;
  std::int64_t time_ns = 0;
  std::string bytes;
  auto operator<=>(const Message&) const = default;
};
inline std::ostream& operator<<(std::ostream& out, const Message& message) {
  return out << message.topic << " at " << message.time_ns << ": " << message.bytes.size()
             << " bytes";
}

/// What is left of a reader. `wanted` are topics by name; all where it is empty.
inline std::vector<Message> rest_of(io::BagReader& bag,
                                    const std::vector<std::string>& wanted = {}) {
  if (!wanted.empty()) {
    std::vector<std::size_t> topics;
    for (std::size_t i = 0; i < bag.topics().size(); ++i) {
      for (const std::string& name : wanted) {
        if (bag.topics()[i].name == name) topics.push_back(i);
      }
    }
    bag.select(topics);
  }
  std::vector<Message> messages;
  while (const auto message = bag.next()) {
    messages.push_back(
        {bag.topics().at(message->topic).name,
         message->log_time_ns,
         {reinterpret_cast<const char*>(message->bytes.data()), message->bytes.size()}});
  }
  return messages;
}

inline std::vector<Message> messages_of(const std::filesystem::path& path,
                                        const std::vector<std::string>& wanted = {}) {
  const auto bag = io::open_bag(path);
  return bag ? rest_of(*bag, wanted) : std::vector<Message>{};
}

inline std::string text_of(const Issues& issues) {
  std::string text;
  for (const Issue& issue : issues) text += to_string(issue) + "\n";
  return text;
}

}  // namespace roomatlas::test::bags
