// SPDX-License-Identifier: GPL-3.0-or-later
// The format: mcap.dev/spec, with its registry of encodings.
#include "mcap_records.hpp"

#include <algorithm>

namespace roomatlas::io {
namespace {

bool is_text(std::string_view schema_encoding) {
  return schema_encoding == "ros1msg" || schema_encoding == "ros2msg" ||
         schema_encoding == "ros2idl" || schema_encoding == "omgidl";
}

}  // namespace

void read_mcap_schema(ByteSpan content, McapSchemas& schemas) {
  ByteCursor cursor(content);
  const std::uint16_t id = cursor.u16();
  if (id == 0 || schemas.contains(id)) return;
  const std::string_view name = cursor.text();
  const std::string_view encoding = cursor.text();
  const std::string_view definition = cursor.text();
  schemas[id] = std::make_shared<McapSchema>(
      McapSchema{std::string(name), is_text(encoding) ? std::string(definition) : ""});
}

McapChannel read_mcap_channel(ByteSpan content) {
  ByteCursor cursor(content);
  McapChannel channel;
  channel.id = cursor.u16();
  channel.schema = cursor.u16();
  channel.topic = cursor.text();
  channel.encoding = cursor.text();
  return channel;  // what people noted about the channel follows
}

Chunk read_mcap_chunk_head(ByteSpan head, std::uint64_t offset, std::uint64_t record_bytes) {
  ByteCursor cursor(head);
  Chunk chunk;
  chunk.header_offset = offset;
  chunk.start_ns = mcap_time_ns(cursor.u64());
  chunk.end_ns = mcap_time_ns(cursor.u64());
  chunk.unpacked_bytes = cursor.u64();
  chunk.crc = cursor.u32();
  chunk.packing = cursor.text();
  chunk.packed_bytes = cursor.u64();
  chunk.offset = offset + kMcapRecordHeader_bytes + cursor.position();
  if (chunk.packed_bytes > record_bytes - cursor.position()) {
    throw DamagedData("a chunk's records are longer than it");
  }
  return chunk;
}

BagTopic mcap_topic(const McapChannel& channel, const McapSchemas& schemas) {
  BagTopic topic;
  topic.name = channel.topic;
  topic.encoding = bag_encoding_of(channel.encoding);
  const auto schema = schemas.find(channel.schema);
  if (schema != schemas.end()) {
    topic.type = plain_type(schema->second->name);
    topic.definition = schema->second->text;
  }
  return topic;
}

std::int64_t mcap_time_ns(std::uint64_t time_ns) {
  return static_cast<std::int64_t>(std::min<std::uint64_t>(time_ns, kLatestTime_ns));
}

void McapFormat::visit(ByteSpan records, RecordVisitor& visitor) const {
  for (ByteCursor cursor(records); !cursor.at_end();) {
    const auto op = static_cast<McapOp>(cursor.u8());
    ByteCursor content(cursor.bytes(cursor.u64()));
    if (op == McapOp::message) {
      const std::uint16_t channel = content.u16();
      content.u32();  // the sequence
      const std::int64_t log_time_ns = mcap_time_ns(content.u64());
      content.u64();  // when it was published
      visitor.message(channel, log_time_ns, content.rest());
    } else if (op == McapOp::schema) {
      read_mcap_schema(content.rest(), *schemas_);
    } else if (op == McapOp::channel) {
      const McapChannel channel = read_mcap_channel(content.rest());
      visitor.connection(channel.id, mcap_topic(channel, *schemas_));
    }
  }
}

void McapFormat::find_content(BagFile& file, Chunk& chunk) const {
  ByteCursor cursor(file.view(chunk.header_offset, kMcapRecordHeader_bytes + kMcapChunkHead_bytes));
  if (static_cast<McapOp>(cursor.u8()) != McapOp::chunk) {
    throw DamagedData("no chunk is where the index says");
  }
  const std::uint64_t record_bytes = cursor.u64();
  Chunk read = read_mcap_chunk_head(cursor.rest(), chunk.header_offset, record_bytes);
  chunk.offset = read.offset;
  chunk.packed_bytes = read.packed_bytes;
  chunk.unpacked_bytes = read.unpacked_bytes;
  chunk.packing = std::move(read.packing);
  chunk.crc = read.crc;
  chunk.content_is_known = true;
}

}  // namespace roomatlas::io
