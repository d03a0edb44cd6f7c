// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bag_bytes.hpp"
#include "read_bag.hpp"

#include <algorithm>

#include <string>
#include <vector>

namespace roomatlas::test::bags {

/// Three chunks of times 100 to 139, 130 to 169 and 160 to 199 (they overlap), with "/a" at even
/// and "/b" at odd numbers; the last has "/a" alone.
struct SmallBag {
  std::string bytes;
  std::vector<Message> messages;    ///< in the order of times
  std::vector<std::size_t> chunks;  ///< where each one's bytes begin, and where the last ends
};

struct SmallChunk {
  std::vector<Message> messages;
};

inline std::vector<SmallChunk> small_chunks() {
  std::vector<SmallChunk> chunks(3);
  for (int chunk = 0; chunk < 3; ++chunk) {
    for (int i = 0; i < 10; ++i) {
      const int number = 10 * chunk + i;
      const bool is_a = chunk == 2 || i % 2 == 0;
      chunks[static_cast<std::size_t>(chunk)].messages.push_back(
          {is_a ? "/a" : "/b", 100 + 30 * chunk + 4 * i,
           std::string(static_cast<std::size_t>(3 + number), static_cast<char>('A' + number))});
    }
  }
  return chunks;
}

inline std::vector<Message> in_time_order(const std::vector<SmallChunk>& chunks) {
  std::vector<Message> all;
  for (const SmallChunk& chunk : chunks) {
    all.insert(all.end(), chunk.messages.begin(), chunk.messages.end());
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Message& a, const Message& b) { return a.time_ns < b.time_ns; });
  return all;
}

inline SmallBag small_ros1_bag(const std::string& packing, bool is_indexed = true) {
  SmallBag bag;
  std::string body;
  std::string infos;
  const std::size_t begin = ros1_beginning(0, 0, 0).size();
  const std::vector<SmallChunk> chunks = small_chunks();
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    std::string records;
    if (i == 0) records += ros1_connection(5, "/a", "std_msgs/String");
    std::vector<std::int64_t> times_ns[2];
    for (const Message& message : chunks[i].messages) {
      const bool is_b = message.topic == "/b";
      if (i == 0 && is_b && times_ns[1].empty()) {
        records += ros1_connection(9, "/b", "std_msgs/Int32");
      }
      times_ns[is_b ? 1 : 0].push_back(message.time_ns);
      records += ros1_message(is_b ? 9 : 5, message.time_ns, message.bytes);
    }
    bag.chunks.push_back(begin + body.size());
    std::vector<std::pair<std::uint32_t, int>> counts = {{5, static_cast<int>(times_ns[0].size())}};
    if (!times_ns[1].empty()) counts.emplace_back(9, static_cast<int>(times_ns[1].size()));
    infos += ros1_chunk_info(begin + body.size(), chunks[i].messages.front().time_ns,
                             chunks[i].messages.back().time_ns, counts);
    body += ros1_chunk(packing, records) + ros1_index(5, times_ns[0]);
    if (!times_ns[1].empty()) body += ros1_index(9, times_ns[1]);
  }
  bag.chunks.push_back(begin + body.size());
  bag.bytes = ros1_beginning(is_indexed ? begin + body.size() : 0, 2, 3) + body;
  if (is_indexed) {
    bag.bytes += ros1_connection(5, "/a", "std_msgs/String") +
                 ros1_connection(9, "/b", "std_msgs/Int32") + infos;
  }
  bag.messages = in_time_order(chunks);
  return bag;
}

struct McapParts {
  std::string packing;  ///< of the chunks
  bool has_chunks = true;
  bool has_message_index = true;
  bool has_summary = true;
  bool repeats_channels = true;
  bool repeats_schemas = true;
  bool has_statistics = true;
  bool has_chunk_index = true;
  bool has_crcs = true;
  std::size_t padding = 0;
};

inline SmallBag small_mcap(const McapParts& parts) {
  SmallBag bag;
  const std::size_t pad = parts.padding;
  const std::string schemas = mcap_schema(3, "std_msgs/msg/String", pad);
  const std::string channels = mcap_channel(1, 3, "/a", pad) + mcap_channel(2, 3, "/b", pad);
  std::string file = kMcapMagic + mcap_header(pad) + mcap_record(0x99, "of the future", pad);
  file += mcap_record(9, u64(1) + u64(1) + block("picture.png") + block("image/png") + u64(3) +
                             "png" + u32(0));  // an attachment
  if (!parts.has_chunks) file += schemas + channels;
  std::string index;
  const std::vector<SmallChunk> chunks = small_chunks();
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    std::string records = i == 0 && parts.has_chunks ? schemas + channels : "";
    std::vector<std::pair<std::int64_t, int>> places[2];
    for (const Message& message : chunks[i].messages) {
      const bool is_b = message.topic == "/b";
      places[is_b ? 1 : 0].emplace_back(message.time_ns, static_cast<int>(records.size()));
      records += mcap_message(is_b ? 2 : 1, message.time_ns, message.bytes);
    }
    bag.chunks.push_back(file.size());
    if (!parts.has_chunks) {
      file += records;
      continue;
    }
    const std::int64_t start_ns = chunks[i].messages.front().time_ns;
    const std::int64_t end_ns = chunks[i].messages.back().time_ns;
    const std::string chunk = mcap_chunk(parts.packing, records, start_ns, end_ns,
                                         parts.has_crcs ? crc(records) : 0, pad);
    std::string indexes;
    std::string offsets;
    for (int channel = 1; parts.has_message_index && channel <= 2; ++channel) {
      const auto& of = places[channel - 1];
      if (of.empty()) continue;
      offsets += u16(static_cast<std::uint64_t>(channel)) +
                 u64(file.size() + chunk.size() + indexes.size());
      indexes += mcap_message_index(channel, of, pad);
    }
    index += mcap_record(
        8,
        u64(static_cast<std::uint64_t>(start_ns)) + u64(static_cast<std::uint64_t>(end_ns)) +
            u64(file.size()) + u64(chunk.size()) + block(offsets) + u64(indexes.size()) +
            block(parts.packing) + u64(packed(parts.packing, records).size()) + u64(records.size()),
        pad);
    file += chunk + indexes;
  }
  bag.chunks.push_back(file.size());
  file += mcap_record(12, block("about") + block(block("key") + block("value")), pad);  // metadata
  file += mcap_record(15, u32(parts.has_crcs ? crc(file) : 0));
  std::string summary;
  if (parts.has_summary) {
    if (parts.repeats_schemas) summary += schemas;
    if (parts.repeats_channels) summary += channels;
    if (parts.has_statistics) {
      summary += mcap_record(11,
                             u64(30) + u16(1) + u32(2) + u32(1) + u32(1) + u32(3) + u64(100) +
                                 u64(196) + block(u16(1) + u64(20) + u16(2) + u64(10)),
                             pad);
    }
    if (parts.has_chunk_index) summary += index;
  }
  const std::uint64_t summary_start = summary.empty() ? 0 : file.size();
  const std::string footer = mcap_footer(summary_start, 0);
  const std::string summed = summary + footer.substr(0, 9 + 16);
  bag.bytes = file + summary + mcap_footer(summary_start, parts.has_crcs ? crc(summed) : 0);
  bag.messages = in_time_order(chunks);
  return bag;
}

}  // namespace roomatlas::test::bags
