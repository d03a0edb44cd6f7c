// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "chunk.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>

namespace roomatlas::io {

/// What a record of an MCAP file is. Others are skipped.
enum class McapOp : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  statistics = 0x0B,
  data_end = 0x0F,
};

inline constexpr std::string_view kMcapMagic = "\x89MCAP0\r\n";
inline constexpr std::size_t kMcapRecordHeader_bytes = 9;  ///< what it is, and its length
/// The most that a chunk's head can be: its packing's name is the only part of any length.
inline constexpr std::size_t kMcapChunkHead_bytes = 4096;

struct McapSchema {
  std::string name;
  std::string text;  ///< of the definition; empty where its encoding is not text
};

struct McapChannel {
  std::uint16_t id = 0;
  std::uint16_t schema = 0;  ///< 0: none
  std::string topic;
  std::string encoding;
};

/// The schemas that a file has described so far, by their ids. Chunks repeat them, so that a file
/// can be read from any of them on.
using McapSchemas = std::unordered_map<std::uint16_t, std::shared_ptr<const McapSchema>>;

// Each reads a record's content, ignores what is behind its fields, and throws DamagedData.
void read_mcap_schema(ByteSpan content, McapSchemas& schemas);
[[nodiscard]] McapChannel read_mcap_channel(ByteSpan content);
/// The head of a chunk's record that lies at `offset`: all but the packed records, which
/// `record_bytes` of content must have room for. They may end behind `file_bytes`.
[[nodiscard]] Chunk read_mcap_chunk_head(ByteSpan head, std::uint64_t offset,
                                         std::uint64_t record_bytes);

[[nodiscard]] BagTopic mcap_topic(const McapChannel& channel, const McapSchemas& schemas);
/// Nanoseconds; times beyond the year 2262 are taken for that.
[[nodiscard]] std::int64_t mcap_time_ns(std::uint64_t time_ns);

/// Records as they lie in chunks.
class McapFormat final : public ChunkFormat {
 public:
  explicit McapFormat(std::shared_ptr<McapSchemas> schemas) : schemas_(std::move(schemas)) {}

  void visit(ByteSpan records, RecordVisitor& visitor) const override;
  /// MCAP's chunks that an index names are read when it is their turn.
  void find_content(BagFile& file, Chunk& chunk) const override;

 private:
  std::shared_ptr<McapSchemas> schemas_;  ///< grows while records are visited
};

}  // namespace roomatlas::io
