// SPDX-License-Identifier: GPL-3.0-or-later
// The format: wiki.ros.org/Bags/Format/2.0.
#include "ros1_records.hpp"

#include <algorithm>

namespace roomatlas::io {
namespace {

constexpr std::uint32_t kLongestHeader_bytes = 1u << 16;  // a topic's name is the longest in it

}  // namespace

Ros1Fields::Ros1Fields(ByteSpan header) {
  for (ByteCursor cursor(header); !cursor.at_end();) {
    const ByteSpan field = cursor.block();
    const std::size_t equals = as_text(field).find('=');
    if (equals == std::string_view::npos) throw DamagedData("a field has no \"=\"");
    if (count_ == kMostFields) throw DamagedData("a header has too many fields");
    fields_[count_++] = {as_text(field).substr(0, equals), field.subspan(equals + 1)};
  }
}

std::optional<ByteSpan> Ros1Fields::find(std::string_view name) const {
  for (std::size_t i = 0; i < count_; ++i) {
    if (fields_[i].name == name) return fields_[i].value;
  }
  return std::nullopt;
}

ByteSpan Ros1Fields::bytes(std::string_view name, std::size_t size) const {
  const auto value = find(name);
  if (!value || value->size() != size) {
    throw DamagedData("a header has no field \"" + std::string(name) + "\" of " +
                      std::to_string(size) + " bytes");
  }
  return *value;
}

std::uint32_t Ros1Fields::u32(std::string_view name) const {
  return ByteCursor(bytes(name, 4)).u32();
}

std::uint64_t Ros1Fields::u64(std::string_view name) const {
  return ByteCursor(bytes(name, 8)).u64();
}

std::int64_t Ros1Fields::time_ns(std::string_view name) const {
  ByteCursor cursor(bytes(name, 8));
  return ros1_time_ns(cursor);
}

Ros1Op Ros1Fields::op() const { return static_cast<Ros1Op>(ByteCursor(bytes("op", 1)).u8()); }

std::string_view Ros1Fields::text(std::string_view name) const {
  const auto value = find(name);
  return value ? as_text(*value) : std::string_view();
}

std::int64_t ros1_time_ns(ByteCursor& cursor) {
  const std::int64_t seconds = cursor.u32();
  const std::int64_t nanoseconds = cursor.u32();
  return std::min(seconds * 1'000'000'000 + nanoseconds, kLatestTime_ns);
}

Ros1Record read_ros1_record(BagFile& file, std::uint64_t offset) {
  const std::uint32_t header_bytes = ByteCursor(file.view(offset, 4)).u32();
  if (header_bytes > kLongestHeader_bytes) throw DamagedData("a record's header is too long");
  ByteCursor cursor(file.view(offset + 4, std::size_t{header_bytes} + 4));
  const ByteSpan header = cursor.bytes(header_bytes);
  const std::uint32_t data_bytes = cursor.u32();
  return {Ros1Fields(header), offset + 8 + header_bytes, data_bytes};
}

BagTopic ros1_topic(std::string_view name, ByteSpan data) {
  const Ros1Fields described(data);
  BagTopic topic;
  topic.name = name;
  topic.type = plain_type(described.text("type"));
  topic.encoding = BagEncoding::ros1;
  topic.definition = described.text("message_definition");
  return topic;
}

void Ros1Format::visit(ByteSpan records, RecordVisitor& visitor) const {
  for (ByteCursor cursor(records); !cursor.at_end();) {
    const Ros1Fields header(cursor.block());
    const ByteSpan data = cursor.block();
    const Ros1Op op = header.op();
    if (op == Ros1Op::message) {
      visitor.message(header.u32("conn"), header.time_ns("time"), data);
    } else if (op == Ros1Op::connection) {
      visitor.connection(header.u32("conn"), ros1_topic(header.text("topic"), data));
    }
  }
}

void Ros1Format::find_content(BagFile& file, Chunk& chunk) const {
  const Ros1Record record = read_ros1_record(file, chunk.header_offset);
  if (record.fields.op() != Ros1Op::chunk) throw DamagedData("no chunk is where the index says");
  set_ros1_content(record, chunk);
}

void set_ros1_content(const Ros1Record& record, Chunk& chunk) {
  chunk.packing = record.fields.text("compression");
  chunk.unpacked_bytes = record.fields.u32("size");
  chunk.offset = record.data_offset;
  chunk.packed_bytes = record.data_bytes;
  chunk.content_is_known = true;
}

}  // namespace roomatlas::io
