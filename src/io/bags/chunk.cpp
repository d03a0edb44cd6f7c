// SPDX-License-Identifier: GPL-3.0-or-later
#include "chunk.hpp"
#include "files/unpack_bounds.hpp"

#include "crc32.hpp"

#include <algorithm>

namespace roomatlas::io {
namespace {

constexpr std::size_t kMostConnections = 256;  // in a stretch of open messages

/// Notes what there is, without keeping it.
class Inventory : public RecordVisitor {
 public:
  Inventory(Chunk& chunk, TopicTable& topics) : chunk_(chunk), topics_(topics) {
    chunk_.messages.clear();
    chunk_.start_ns = std::numeric_limits<std::int64_t>::max();
    chunk_.end_ns = std::numeric_limits<std::int64_t>::min();
  }
  void connection(std::uint32_t connection, BagTopic topic) override {
    topics_.connect(connection, std::move(topic));
  }
  void message(std::uint32_t connection, std::int64_t log_time_ns, ByteSpan) override {
    chunk_.start_ns = std::min(chunk_.start_ns, log_time_ns);
    chunk_.end_ns = std::max(chunk_.end_ns, log_time_ns);
    ++messages_[connection];
  }
  void finish() {
    for (const auto& [connection, messages] : messages_) {
      chunk_.messages.push_back({connection, messages});
      topics_.count(connection, messages);
    }
    std::sort(chunk_.messages.begin(), chunk_.messages.end(),
              [](const auto& a, const auto& b) { return a.connection < b.connection; });
    if (messages_.empty()) chunk_.start_ns = chunk_.end_ns = 0;
  }

 private:
  Chunk& chunk_;
  TopicTable& topics_;
  std::unordered_map<std::uint32_t, std::uint32_t> messages_;
};

}  // namespace

std::string ChunkLoader::load(const Chunk& chunk, Buffer& content) {
  content.clear();
  const auto packing = packing_of(chunk.packing);
  if (!packing) {
    return "it is packed by \"" + chunk.packing.substr(0, 40) +
           "\", which is not known here; known are bz2, lz4 and zstd: pack the recording anew";
  }
  if (std::max(chunk.unpacked_bytes, chunk.packed_bytes) > kLargestChunk_bytes) {
    return "it claims more than 1 GiB";
  }
  if (chunk.unpacked_bytes > most_unpacked_bytes(chunk.packed_bytes, kMostGrowth)) {
    return "it claims to grow to more than " + std::to_string(kMostGrowth) +
           " times its size: nothing that was recorded does";
  }
  if (unpacked_bytes_ > most_unpacked_bytes(file_.size(), kMostGrowthStreamed)) {
    return "the chunks before it are more than " + std::to_string(kMostGrowthStreamed) +
           " times the file's size: nothing that was recorded is";
  }
  const auto packed_bytes = static_cast<std::size_t>(
      std::min(chunk.packed_bytes, file_.size() - std::min(file_.size(), chunk.offset)));
  Buffer& packed = *packing == Packing::none ? content : packed_;
  packed.resize(packed_bytes);
  packed.resize(file_.read(chunk.offset, packed.span()));
  std::string fault;
  if (*packing != Packing::none && chunk.unpacked_bytes > 0) {
    fault = unpacker_.unpack(*packing, packed.view(), chunk.unpacked_bytes, content);
  }
  unpacked_bytes_ += content.size();
  if (packed.size() < chunk.packed_bytes) return "the file ends inside it";
  if (!fault.empty()) return fault;
  if (content.size() != chunk.unpacked_bytes) return "it unpacks to fewer bytes than it claims";
  if (chunk.crc != 0 && crc32_of(content.view()) != chunk.crc) {
    content.clear();
    return "its CRC is wrong, so that any of its messages may be";
  }
  return "";
}

void take_inventory(Chunk& chunk, const ChunkFormat& format, ChunkLoader& loader,
                    BagLayout& layout) {
  Buffer content;
  const std::string fault = loader.load(chunk, content);
  if (layout.first_fault.empty()) layout.first_fault = fault;
  bool is_whole = fault.empty();
  Inventory inventory(chunk, layout.topics);
  try {
    format.visit(content.view(), inventory);
  } catch (const DamagedData&) {
    is_whole = false;
  }
  inventory.finish();
  chunk.messages_are_known = is_whole;  // else it is read whatever is wanted, and its fault is said
}

void require_topics(const BagLayout& layout, const std::string& file) {
  if (!layout.topics.topics().empty()) return;
  std::string why =
      layout.first_fault.empty() ? "" : "a chunk cannot be read: " + layout.first_fault;
  for (const Issue& issue : layout.issues.list()) {
    if (issue.severity != Severity::note) why += (why.empty() ? "" : "; ") + issue.message;
  }
  throw InputError(file + ": holds no topic that can be read, though it is " + layout.container +
                   (why.empty() ? ": nothing was recorded in it" : ": " + why));
}

void count_indexed(Chunk& chunk, const ChunkFormat& format, ChunkLoader& loader,
                   BagLayout& layout) {
  const bool is_clear =
      !chunk.messages.empty() &&
      std::all_of(chunk.messages.begin(), chunk.messages.end(),
                  [&](const auto& of) { return layout.topics.knows(of.connection); });
  if (!is_clear) return take_inventory(chunk, format, loader, layout);
  chunk.messages_are_known = true;
  for (const ConnectionCount& of : chunk.messages) {
    layout.topics.count(of.connection, of.messages);
  }
}

void add_open_message(BagLayout& layout, std::uint64_t begin, std::uint64_t end,
                      std::uint32_t connection, std::int64_t log_time_ns) {
  Chunk* last = layout.chunks.empty() ? nullptr : &layout.chunks.back();
  const bool is_large = end - begin > kOwnStretch_bytes;
  const bool continues = last != nullptr && last->header_offset == ~std::uint64_t{0} &&
                         last->offset + last->packed_bytes == begin && !is_large &&
                         last->packed_bytes < kStretch_bytes &&
                         last->messages.size() < kMostConnections;
  if (!continues) {
    Chunk stretch;
    stretch.header_offset = is_large ? 0 : ~std::uint64_t{0};  // a large one is not continued
    stretch.offset = begin;
    stretch.start_ns = stretch.end_ns = log_time_ns;
    stretch.messages_are_known = true;
    layout.chunks.push_back(std::move(stretch));
    last = &layout.chunks.back();
  }
  last->packed_bytes = last->unpacked_bytes = end - last->offset;
  last->start_ns = std::min(last->start_ns, log_time_ns);
  last->end_ns = std::max(last->end_ns, log_time_ns);
  const auto known = std::find_if(last->messages.begin(), last->messages.end(),
                                  [&](const auto& of) { return of.connection == connection; });
  if (known == last->messages.end()) {
    last->messages.push_back({connection, 1});
  } else {
    ++known->messages;
  }
  layout.topics.count(connection, 1);
}

}  // namespace roomatlas::io
