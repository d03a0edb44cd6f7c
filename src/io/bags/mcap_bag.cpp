// SPDX-License-Identifier: GPL-3.0-or-later
#include "mcap_bag.hpp"

#include "chunked_reader.hpp"
#include "crc32.hpp"
#include "mcap_summary.hpp"

#include <algorithm>
#include <utility>

namespace roomatlas::io {
namespace {

constexpr std::size_t kMessageHead_bytes = 22;
constexpr std::uint64_t kLongestDescription_bytes = std::uint64_t{1} << 24;
// Chunks that are not packed and are larger are not held: their records are taken as if they lay
// outside of chunks.
constexpr std::uint64_t kLargestHeldPlain_bytes = std::uint64_t{1} << 24;
constexpr std::uint64_t kLargestSummed_bytes = std::uint64_t{1} << 26;

/// Goes over the records of a file, jumps over chunks that the summary knows, and finds what is
/// where.
class Pass {
 public:
  Pass(BagFile& file, McapSummary& summary, std::shared_ptr<McapSchemas> schemas, BagLayout& layout)
      : file_(file),
        summary_(summary),
        schemas_(std::move(schemas)),
        layout_(layout),
        format_(schemas_),
        loader_(file) {
    for (const McapChannel& channel : summary_.channels) add(channel);
  }

  void run() {
    std::uint64_t offset = kMcapMagic.size();
    try {
      run(offset, summary_.data_end);
    } catch (const DamagedData& damage) {
      layout_.issues.add(Severity::warning,
                         "it is cut short or damaged at byte " + std::to_string(offset) + " (" +
                             damage.what() + "): what is behind it was left out",
                         "bytes", static_cast<std::int64_t>(file_.size() - offset));
    }
    is_inside_chunk_ = false;
    finish_chunk();
    if (summary_.messages) {
      layout_.topics.recount(*summary_.messages);
    } else if (has_jumped_) {
      layout_.topics.forget_counts();
    }
    check_data();
  }

 private:
  /// `offset` is moved on to where `run` comes; behind a fault it says where that is.
  void run(std::uint64_t& offset, std::uint64_t end) {
    while (offset < end && !found_data_end_) {
      const auto indexed = summary_.chunks.find(offset);
      if (indexed != summary_.chunks.end() && !is_large_and_plain(indexed->second.chunk)) {
        offset = take_indexed(indexed->second);
      } else {
        offset = take(offset, end);
      }
    }
  }

  static bool is_large_and_plain(const Chunk& chunk) {
    return chunk.packing.empty() && chunk.unpacked_bytes > kLargestHeldPlain_bytes;
  }

  std::uint64_t take_indexed(const McapIndexedChunk& indexed) {
    finish_chunk();
    layout_.chunks.push_back(indexed.chunk);
    Chunk& chunk = layout_.chunks.back();
    const bool is_clear =
        std::all_of(chunk.messages.begin(), chunk.messages.end(),
                    [&](const auto& of) { return layout_.topics.knows(of.connection); });
    const bool may_have_unknown = !chunk.messages_are_known && !summary_.has_all_channels;
    if (!is_clear || may_have_unknown) {
      format_.find_content(file_, chunk);
      take_inventory(chunk, format_, loader_, layout_);
    } else {
      has_jumped_ = true;
    }
    return indexed.end;
  }

  /// Returns where the next record begins.
  std::uint64_t take(std::uint64_t offset, std::uint64_t end) {
    ByteCursor cursor(file_.view(offset, kMcapRecordHeader_bytes));
    const auto op = static_cast<McapOp>(cursor.u8());
    const std::uint64_t bytes = cursor.u64();
    const std::uint64_t content = offset + kMcapRecordHeader_bytes;
    if (op != McapOp::message_index) finish_chunk();
    if (op == McapOp::chunk && !is_inside_chunk_) return take_chunk(offset, bytes);
    if (bytes > end - std::min(end, content)) throw DamagedData("the file ends inside a record");
    switch (op) {
      case McapOp::schema:
        read_mcap_schema(description(content, bytes), *schemas_);
        break;
      case McapOp::channel:
        add(read_mcap_channel(description(content, bytes)));
        break;
      case McapOp::message: {
        if (bytes < kMessageHead_bytes) throw DamagedData("a message is too short");
        ByteCursor head(file_.view(content, kMessageHead_bytes));
        const std::uint16_t channel = head.u16();
        head.u32();
        add_open_message(layout_, offset, content + bytes, channel, mcap_time_ns(head.u64()));
        break;
      }
      case McapOp::message_index:
        if (chunk_is_open_) add_message_index(content, bytes);
        break;
      case McapOp::data_end:
        data_crc_ = ByteCursor(description(content, bytes)).u32();
        data_bytes_ = offset;
        found_data_end_ = true;
        break;
      case McapOp::footer:
        found_data_end_ = true;
        break;
      default:
        break;  // attachments, metadata, and what is not known
    }
    return content + bytes;
  }

  std::uint64_t take_chunk(std::uint64_t offset, std::uint64_t bytes) {
    const std::uint64_t content = offset + kMcapRecordHeader_bytes;
    Chunk chunk = read_mcap_chunk_head(file_.view(content, kMcapChunkHead_bytes), offset, bytes);
    if (bytes > std::numeric_limits<std::uint64_t>::max() - content) {
      throw DamagedData("a chunk's length is impossible");
    }
    if (is_large_and_plain(chunk)) {
      std::uint64_t inner = chunk.offset;
      is_inside_chunk_ = true;
      run(inner, std::min(chunk.offset + chunk.packed_bytes, file_.size()));
      is_inside_chunk_ = false;
    } else {
      layout_.chunks.push_back(std::move(chunk));
      chunk_is_open_ = true;
    }
    return content + bytes;  // may lie behind the file: what is whole of it is read
  }

  ByteSpan description(std::uint64_t offset, std::uint64_t bytes) {
    if (bytes > kLongestDescription_bytes) throw DamagedData("a description is too long");
    return file_.view(offset, static_cast<std::size_t>(bytes));
  }

  /// How many messages of one channel are in the chunk before.
  void add_message_index(std::uint64_t offset, std::uint64_t bytes) {
    if (bytes < 6) throw DamagedData("a message index is too short");
    constexpr std::uint32_t kEntry_bytes = 16;
    ByteCursor cursor(file_.view(offset, 6));
    const std::uint16_t channel = cursor.u16();
    layout_.chunks.back().messages.push_back({channel, cursor.u32() / kEntry_bytes});
  }

  void finish_chunk() {
    if (!std::exchange(chunk_is_open_, false)) return;
    count_indexed(layout_.chunks.back(), format_, loader_, layout_);
  }

  void check_data() {
    if (data_crc_ == 0 || data_bytes_ > kLargestSummed_bytes) return;
    const ByteSpan data = file_.view(0, static_cast<std::size_t>(data_bytes_));
    if (crc32_of(data) == data_crc_) return;
    layout_.issues.add(Severity::warning,
                       "the CRC of its data section is wrong: something in it may be, and was kept "
                       "where no chunk's own CRC is wrong");
  }

  void add(const McapChannel& channel) {
    layout_.topics.connect(channel.id, mcap_topic(channel, *schemas_));
  }

  BagFile& file_;
  McapSummary& summary_;
  std::shared_ptr<McapSchemas> schemas_;
  BagLayout& layout_;
  McapFormat format_;
  ChunkLoader loader_;
  bool chunk_is_open_ = false;
  bool found_data_end_ = false;
  std::uint32_t data_crc_ = 0;
  std::uint64_t data_bytes_ = 0;  ///< the data section, with the magic before it
  bool is_inside_chunk_ = false;
  bool has_jumped_ = false;  ///< over a chunk whose messages were not counted
};

}  // namespace

std::unique_ptr<BagReader> open_mcap(std::unique_ptr<BagFile> file) {
  BagLayout layout(file->name());
  layout.container = "MCAP";
  const auto schemas = std::make_shared<McapSchemas>();
  McapSummary summary = read_mcap_summary(*file, *schemas);
  if (!summary.is_closed) {
    layout.issues.add(Severity::warning,
                      "its end is missing: it was cut short, or its recording was not closed");
  }
  if (!summary.damage.empty()) {
    layout.issues.add(Severity::warning,
                      "its summary is damaged (" + summary.damage + "): it was read without");
  }
  Pass(*file, summary, schemas, layout).run();
  require_topics(layout, file->name());
  return std::make_unique<ChunkedReader>(std::move(file), std::make_unique<McapFormat>(schemas),
                                         std::move(layout));
}

}  // namespace roomatlas::io
