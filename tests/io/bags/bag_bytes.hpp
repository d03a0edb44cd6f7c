// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bzlib.h>
#include <lz4frame.h>
#include <zlib.h>
#include <zstd.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// Recordings, put together byte by byte as their specifications say. Knows nothing of the readers
/// and writers that are tested with it.
namespace roomatlas::test::bags {

inline std::string number(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xff);
  return text;
}
inline std::string u16(std::uint64_t value) { return number(value, 2); }
inline std::string u32(std::uint64_t value) { return number(value, 4); }
inline std::string u64(std::uint64_t value) { return number(value, 8); }
inline std::string block(const std::string& text) { return u32(text.size()) + text; }

inline std::uint32_t crc(const std::string& bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

inline std::string packed(const std::string& packing, const std::string& bytes) {
  std::string out(2 * bytes.size() + 4096, '\0');
  if (packing == "bz2") {
    auto size = static_cast<unsigned>(out.size());
    BZ2_bzBuffToBuffCompress(out.data(), &size, const_cast<char*>(bytes.data()),
                             static_cast<unsigned>(bytes.size()), 9, 0, 0);
    return out.substr(0, size);
  }
  if (packing == "lz4") {
    return out.substr(
        0, LZ4F_compressFrame(out.data(), out.size(), bytes.data(), bytes.size(), nullptr));
  }
  if (packing == "zstd") {
    return out.substr(0, ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), 3));
  }
  return bytes;
}

// ROS 1 bag 2.0

using Fields = std::vector<std::pair<std::string, std::string>>;

inline std::string ros1_header(const Fields& fields) {
  std::string text;
  for (const auto& [name, value] : fields) text += block(name + "=" + value);
  return text;
}
inline std::string ros1_record(const Fields& fields, const std::string& data) {
  return block(ros1_header(fields)) + block(data);
}
inline std::string ros1_time(std::int64_t ns) {
  return u32(static_cast<std::uint64_t>(ns / 1'000'000'000)) +
         u32(static_cast<std::uint64_t>(ns % 1'000'000'000));
}
inline std::string ros1_connection(std::uint32_t id, const std::string& topic,
                                   const std::string& type) {
  return ros1_record({{"op", "\x07"}, {"conn", u32(id)}, {"topic", topic}},
                     ros1_header({{"topic", topic},
                                  {"type", type},
                                  {"md5sum", "0123456789abcdef0123456789abcdef"},
                                  {"message_definition", "string data\n"}}));
}
inline std::string ros1_message(std::uint32_t connection, std::int64_t time_ns,
                                const std::string& data) {
  return ros1_record({{"op", "\x02"}, {"conn", u32(connection)}, {"time", ros1_time(time_ns)}},
                     data);
}
inline std::string ros1_chunk(const std::string& packing, const std::string& records) {
  return ros1_record({{"op", "\x05"}, {"compression", packing}, {"size", u32(records.size())}},
                     packed(packing, records));
}
inline std::string ros1_index(std::uint32_t connection, const std::vector<std::int64_t>& times_ns) {
  std::string data;
  for (const std::int64_t time_ns : times_ns) data += ros1_time(time_ns) + u32(0);
  return ros1_record(
      {{"op", "\x04"}, {"ver", u32(1)}, {"conn", u32(connection)}, {"count", u32(times_ns.size())}},
      data);
}
inline std::string ros1_chunk_info(std::uint64_t offset, std::int64_t start_ns, std::int64_t end_ns,
                                   const std::vector<std::pair<std::uint32_t, int>>& counts) {
  std::string data;
  for (const auto& [connection, count] : counts) {
    data += u32(connection) + u32(static_cast<std::uint64_t>(count));
  }
  return ros1_record({{"op", "\x06"},
                      {"ver", u32(1)},
                      {"chunk_pos", u64(offset)},
                      {"start_time", ros1_time(start_ns)},
                      {"end_time", ros1_time(end_ns)},
                      {"count", u32(counts.size())}},
                     data);
}
/// The magic and the bag header, which fill 4096 bytes behind the magic.
inline std::string ros1_beginning(std::uint64_t index_offset, std::uint32_t connections,
                                  std::uint32_t chunks) {
  const std::string header = ros1_header({{"op", "\x03"},
                                          {"index_pos", u64(index_offset)},
                                          {"conn_count", u32(connections)},
                                          {"chunk_count", u32(chunks)}});
  return "#ROSBAG V2.0\n" + block(header) + block(std::string(4096 - 8 - header.size(), ' '));
}

// MCAP

inline const std::string kMcapMagic("\x89MCAP0\r\n");

/// `padding` bytes behind the fields: readers have to ignore them.
inline std::string mcap_record(int op, const std::string& content, std::size_t padding = 0) {
  return std::string(1, static_cast<char>(op)) + u64(content.size() + padding) + content +
         std::string(padding, '\x5a');
}
inline std::string mcap_header(std::size_t padding = 0) {
  return mcap_record(1, block("ros2") + block("test"), padding);
}
inline std::string mcap_schema(int id, const std::string& name, std::size_t padding = 0) {
  return mcap_record(
      3,
      u16(static_cast<std::uint64_t>(id)) + block(name) + block("ros2msg") + block("string data"),
      padding);
}
inline std::string mcap_channel(int id, int schema, const std::string& topic,
                                std::size_t padding = 0) {
  return mcap_record(4,
                     u16(static_cast<std::uint64_t>(id)) + u16(static_cast<std::uint64_t>(schema)) +
                         block(topic) + block("cdr") + block(block("key") + block("value")),
                     padding);
}
inline std::string mcap_message(int channel, std::int64_t time_ns, const std::string& data) {
  const auto time = static_cast<std::uint64_t>(time_ns);
  return mcap_record(
      5, u16(static_cast<std::uint64_t>(channel)) + u32(7) + u64(time) + u64(time) + data);
}
inline std::string mcap_chunk(const std::string& packing, const std::string& records,
                              std::int64_t start_ns, std::int64_t end_ns, std::uint32_t checksum,
                              std::size_t padding = 0) {
  const std::string content = packed(packing, records);
  return mcap_record(6,
                     u64(static_cast<std::uint64_t>(start_ns)) +
                         u64(static_cast<std::uint64_t>(end_ns)) + u64(records.size()) +
                         u32(checksum) + block(packing) + u64(content.size()) + content,
                     padding);
}
inline std::string mcap_message_index(int channel,
                                      const std::vector<std::pair<std::int64_t, int>>& entries,
                                      std::size_t padding = 0) {
  std::string array;
  for (const auto& [time_ns, offset] : entries) {
    array += u64(static_cast<std::uint64_t>(time_ns)) + u64(static_cast<std::uint64_t>(offset));
  }
  return mcap_record(7, u16(static_cast<std::uint64_t>(channel)) + block(array), padding);
}
inline std::string mcap_footer(std::uint64_t summary_start, std::uint32_t summary_crc) {
  return mcap_record(2, u64(summary_start) + u64(0) + u32(summary_crc)) + kMcapMagic;
}

}  // namespace roomatlas::test::bags
