// SPDX-License-Identifier: GPL-3.0-or-later
#include "chunked_reader.hpp"

#include <algorithm>
#include <utility>

namespace roomatlas::io {
namespace {

// Chunks of one time that are held together; beyond it the order gives way.
constexpr std::uint64_t kMostHeld_bytes = std::uint64_t{1} << 28;
// Buffers larger than this are given back, not kept for the next chunk.
constexpr std::size_t kKeptBuffer_bytes = std::size_t{1} << 26;

/// "ROS 1 bag 2.0 (lz4)", or both of two packings.
std::string format_text(const BagLayout& layout) {
  std::string text;
  for (const Chunk& chunk : layout.chunks) {
    const std::string name = chunk.packing == "none" ? "" : chunk.packing;
    if (name.empty()) continue;
    if ((", " + text + ",").find(", " + name + ",") != std::string::npos) continue;
    text += (text.empty() ? "" : ", ") + name;
    if (text.size() > 60) break;
  }
  return layout.container + (text.empty() ? "" : " (" + text + ")");
}

}  // namespace

/// Notes where the wanted messages of a chunk lie.
class ChunkedReader::Collector : public RecordVisitor {
 public:
  Collector(TopicTable& topics, const std::vector<char>& wanted, std::vector<Entry>& entries)
      : topics_(topics), wanted_(wanted), entries_(entries) {}

  void connection(std::uint32_t connection, BagTopic topic) override {
    topics_.connect(connection, std::move(topic));
  }
  void message(std::uint32_t connection, std::int64_t log_time_ns, ByteSpan bytes) override {
    ++messages;
    const auto topic = topics_.topic_of(connection);
    if (!topic || *topic >= wanted_.size()) ++unknown;
    if (!topic || *topic >= wanted_.size() || wanted_[*topic] == 0) return;
    is_sorted = is_sorted && (entries_.empty() || entries_.back().log_time_ns <= log_time_ns);
    entries_.push_back({log_time_ns, *topic, bytes});
  }

  std::int64_t messages = 0;
  std::int64_t unknown = 0;
  bool is_sorted = true;

 private:
  TopicTable& topics_;
  const std::vector<char>& wanted_;
  std::vector<Entry>& entries_;
};

bool ChunkedReader::Later::operator()(const OpenChunk* a, const OpenChunk* b) const {
  const std::int64_t time_a = a->entries[a->next].log_time_ns;
  const std::int64_t time_b = b->entries[b->next].log_time_ns;
  return time_a != time_b ? time_a > time_b : a->number > b->number;
}

ChunkedReader::ChunkedReader(std::unique_ptr<BagFile> file,
                             std::unique_ptr<ChunkFormat> chunk_format, BagLayout layout)
    : file_(std::move(file)),
      chunk_format_(std::move(chunk_format)),
      layout_(std::move(layout)),
      loader_(*file_),
      format_(format_text(layout_)),
      wanted_(layout_.topics.topics().size(), 1) {
  if (layout_.topics.left_out() > 0) {
    layout_.issues.add(Severity::warning,
                       "it has more than " + std::to_string(TopicTable::kMostTopics) +
                           " topics: the further ones are left out, with their messages",
                       "topics", layout_.topics.left_out());
  }
}

void ChunkedReader::select(const std::vector<std::size_t>& topics) {
  std::fill(wanted_.begin(), wanted_.end(), char{0});
  for (const std::size_t topic : topics) wanted_.at(topic) = 1;
}

/// Leaves only the chunks that have something wanted, in the order of time.
void ChunkedReader::start() {
  is_started_ = true;
  std::vector<Chunk>& chunks = layout_.chunks;
  const auto is_unwanted = [&](const Chunk& chunk) {
    return chunk.messages_are_known &&
           std::none_of(chunk.messages.begin(), chunk.messages.end(), [&](const auto& of) {
             const auto topic = layout_.topics.topic_of(of.connection);
             // What no connection is known for is read, so that it is counted and said.
             return of.messages > 0 &&
                    (topic ? wanted_[*topic] != 0 : !layout_.topics.knows(of.connection));
           });
  };
  std::erase_if(chunks, is_unwanted);
  std::stable_sort(chunks.begin(), chunks.end(),
                   [](const Chunk& a, const Chunk& b) { return a.start_ns < b.start_ns; });
  for (const Chunk& chunk : chunks) total_bytes_ += std::max<std::uint64_t>(1, chunk.packed_bytes);
}

void ChunkedReader::open_chunks() {
  while (next_chunk_ < layout_.chunks.size()) {
    if (!open_.empty()) {
      const OpenChunk& earliest = *open_.top();
      const bool is_later =
          layout_.chunks[next_chunk_].start_ns > earliest.entries[earliest.next].log_time_ns;
      if (is_later || held_bytes_ >= kMostHeld_bytes) return;
    }
    open(layout_.chunks[next_chunk_++]);
  }
}

void ChunkedReader::open(Chunk& chunk) {
  read_bytes_ += std::max<std::uint64_t>(1, chunk.packed_bytes);
  std::int64_t expected = 0;
  for (const ConnectionCount& of : chunk.messages) expected += of.messages;
  if (free_.empty()) {
    all_.push_back(std::make_unique<OpenChunk>());
    free_.push_back(all_.back().get());
  }
  OpenChunk* const opened = free_.back();
  free_.pop_back();
  opened->entries.clear();
  opened->next = 0;
  opened->number = next_chunk_;
  Collector collector(layout_.topics, wanted_, opened->entries);
  std::string fault;
  try {
    if (!chunk.content_is_known) chunk_format_->find_content(*file_, chunk);
    fault = loader_.load(chunk, opened->content);
    chunk_format_->visit(opened->content.view(), collector);
  } catch (const DamagedData& damage) {
    if (fault.empty()) fault = std::string("its records are damaged: ") + damage.what();
  }
  chunk.messages = {};
  if (!fault.empty()) {
    layout_.issues.left_out("a chunk was left out, or its rest behind what is whole: " + fault,
                            std::max<std::int64_t>(0, expected - collector.messages));
  }
  if (collector.unknown > 0) {
    layout_.issues.add(Severity::warning, "messages of connections that are not described",
                       "messages left out", collector.unknown);
  }
  if (!collector.is_sorted) {
    std::stable_sort(opened->entries.begin(), opened->entries.end(),
                     [](const Entry& a, const Entry& b) { return a.log_time_ns < b.log_time_ns; });
  }
  held_bytes_ += opened->content.capacity();
  if (opened->entries.empty()) return close(opened);
  open_.push(opened);
}

void ChunkedReader::close(OpenChunk* chunk) {
  held_bytes_ -= chunk->content.capacity();
  if (chunk->content.capacity() > kKeptBuffer_bytes || free_.size() > 4) chunk->content = Buffer();
  free_.push_back(chunk);
}

std::optional<BagMessage> ChunkedReader::next() {
  if (!is_started_) start();
  if (current_ != nullptr) {
    ++current_->next;
    if (current_->next < current_->entries.size()) {
      open_.push(current_);
    } else {
      close(current_);
    }
    current_ = nullptr;
  }
  open_chunks();
  if (open_.empty()) return std::nullopt;
  current_ = open_.top();
  open_.pop();
  const Entry& entry = current_->entries[current_->next];
  if (entry.log_time_ns < last_time_ns_) {
    layout_.issues.add(Severity::note,
                       "messages come after later ones: their chunks lie too far apart, or say "
                       "wrong times",
                       "messages", 1);
  }
  last_time_ns_ = entry.log_time_ns;
  return BagMessage{entry.topic, entry.log_time_ns, entry.bytes};
}

double ChunkedReader::progress() const {
  if (!is_started_) return 0.0;
  if (total_bytes_ == 0) return 1.0;
  return static_cast<double>(read_bytes_) / static_cast<double>(total_bytes_);
}

}  // namespace roomatlas::io
