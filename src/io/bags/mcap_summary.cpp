// SPDX-License-Identifier: GPL-3.0-or-later
#include "mcap_summary.hpp"

#include "crc32.hpp"

namespace roomatlas::io {
namespace {

constexpr std::size_t kFooterContent_bytes = 20;
constexpr std::size_t kFooterCrc_bytes = 4;  // the last field, which its own sum leaves out
constexpr std::size_t kFooter_bytes = kMcapRecordHeader_bytes + kFooterContent_bytes;
constexpr std::uint64_t kLargestSummary_bytes = std::uint64_t{1} << 29;

struct Footer {
  std::uint64_t summary_start = 0;  ///< 0: there is none
  std::uint32_t summary_crc = 0;    ///< 0: there is none
  std::uint64_t offset = 0;
};

std::optional<Footer> read_footer(BagFile& file) {
  const std::size_t bytes = kFooter_bytes + kMcapMagic.size();
  if (file.size() < kMcapMagic.size() + bytes) return std::nullopt;
  Footer footer;
  footer.offset = file.size() - bytes;
  const ByteSpan end = file.view(footer.offset, bytes);
  if (end.size() < bytes || as_text(end.last(kMcapMagic.size())) != kMcapMagic) return std::nullopt;
  ByteCursor cursor(end);
  if (static_cast<McapOp>(cursor.u8()) != McapOp::footer) return std::nullopt;
  if (cursor.u64() != kFooterContent_bytes) return std::nullopt;
  footer.summary_start = cursor.u64();
  cursor.u64();  // where the summary's own index begins
  footer.summary_crc = cursor.u32();
  return footer;
}

McapIndexedChunk read_chunk_index(ByteCursor cursor, std::uint64_t file_bytes) {
  McapIndexedChunk indexed;
  Chunk& chunk = indexed.chunk;
  chunk.start_ns = mcap_time_ns(cursor.u64());
  chunk.end_ns = mcap_time_ns(cursor.u64());
  chunk.header_offset = cursor.u64();
  const std::uint64_t chunk_bytes = cursor.u64();
  ByteCursor places(cursor.block());
  const std::uint64_t message_index_bytes = cursor.u64();
  chunk.packing = cursor.text();
  chunk.packed_bytes = cursor.u64();
  chunk.unpacked_bytes = cursor.u64();
  chunk.content_is_known = false;
  if (chunk_bytes < kMcapRecordHeader_bytes || chunk.header_offset > file_bytes ||
      chunk_bytes > file_bytes - chunk.header_offset ||
      message_index_bytes > file_bytes - chunk.header_offset - chunk_bytes) {
    throw DamagedData("a chunk lies behind the file's end");
  }
  indexed.end = chunk.header_offset + chunk_bytes + message_index_bytes;
  while (!places.at_end()) {
    // How many they are, nobody knows: one at least.
    chunk.messages.push_back({places.u16(), 1});
    places.u64();
  }
  chunk.messages_are_known = message_index_bytes > 0;
  return indexed;
}

std::map<std::uint16_t, std::uint64_t> read_message_counts(ByteCursor cursor) {
  // All messages; schemas, channels, attachments, metadata, chunks; the first and the last time.
  cursor.bytes(8 + 2 + 4 + 4 + 4 + 4 + 8 + 8);
  std::map<std::uint16_t, std::uint64_t> counts;
  for (ByteCursor pairs(cursor.block()); !pairs.at_end();) {
    const std::uint16_t channel = pairs.u16();
    counts[channel] = pairs.u64();
  }
  return counts;
}

void read_records(ByteSpan records, std::uint64_t file_bytes, McapSummary& summary,
                  McapSchemas& schemas) {
  for (ByteCursor cursor(records); !cursor.at_end();) {
    const auto op = static_cast<McapOp>(cursor.u8());
    const ByteSpan content = cursor.bytes(cursor.u64());
    if (op == McapOp::schema) {
      read_mcap_schema(content, schemas);
    } else if (op == McapOp::channel) {
      summary.channels.push_back(read_mcap_channel(content));
    } else if (op == McapOp::chunk_index) {
      McapIndexedChunk indexed = read_chunk_index(ByteCursor(content), file_bytes);
      const std::uint64_t offset = indexed.chunk.header_offset;
      summary.chunks.emplace(offset, std::move(indexed));
    } else if (op == McapOp::statistics) {
      summary.messages = read_message_counts(ByteCursor(content));
    }
  }
}

/// Of the summary's bytes and the footer's up to the sum itself.
bool has_right_crc(ByteSpan from_summary_to_footer, std::uint32_t crc) {
  return crc == 0 || crc == crc32_of(from_summary_to_footer);
}

}  // namespace

McapSummary read_mcap_summary(BagFile& file, McapSchemas& schemas) {
  McapSummary summary;
  summary.data_end = file.size();
  const auto footer = read_footer(file);
  if (!footer) return summary;
  summary.is_closed = true;
  summary.data_end = footer->offset;
  if (footer->summary_start == 0) return summary;
  const std::uint64_t bytes = footer->offset - footer->summary_start;
  if (footer->summary_start > footer->offset || bytes > kLargestSummary_bytes) {
    summary.damage = "it lies where it cannot be";
    return summary;
  }
  const std::size_t summed_bytes =
      static_cast<std::size_t>(bytes) + kFooter_bytes - kFooterCrc_bytes;
  const ByteSpan summed = file.view(footer->summary_start, summed_bytes);
  const bool is_whole = summed.size() == summed_bytes;
  McapSummary read = summary;
  McapSchemas read_schemas;
  try {
    if (!is_whole || !has_right_crc(summed, footer->summary_crc)) {
      throw DamagedData("its CRC is wrong");
    }
    read_records(summed.first(static_cast<std::size_t>(bytes)), file.size(), read, read_schemas);
  } catch (const DamagedData& damage) {
    summary.damage = damage.what();
    return summary;
  }
  read.data_end = footer->summary_start;
  const std::size_t all = read.channels.size();
  std::erase_if(read.channels, [&](const McapChannel& channel) {
    return channel.schema != 0 && !read_schemas.contains(channel.schema);
  });
  read.has_all_channels = all > 0 && read.channels.size() == all;
  schemas.merge(read_schemas);
  return read;
}

}  // namespace roomatlas::io
