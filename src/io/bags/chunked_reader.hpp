// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "chunk.hpp"

#include <memory>
#include <queue>
#include <vector>

namespace roomatlas::io {

/// Reads a recording that is made of chunks in the order of log times, also where chunks overlap.
/// Chunks without a wanted topic are neither read nor unpacked. What is held: the chunks that the
/// present time lies in.
class ChunkedReader final : public BagReader {
 public:
  ChunkedReader(std::unique_ptr<BagFile> file, std::unique_ptr<ChunkFormat> chunk_format,
                BagLayout layout);

  [[nodiscard]] const std::string& format() const override { return format_; }
  [[nodiscard]] const std::vector<BagTopic>& topics() const override {
    return layout_.topics.topics();
  }
  void select(const std::vector<std::size_t>& topics) override;
  [[nodiscard]] std::optional<BagMessage> next() override;
  [[nodiscard]] Issues issues() const override { return layout_.issues.list(); }
  [[nodiscard]] double progress() const override;

 private:
  struct Entry {
    std::int64_t log_time_ns;
    std::size_t topic;
    ByteSpan bytes;
  };
  struct OpenChunk {
    Buffer content;
    std::vector<Entry> entries;  ///< by log time
    std::size_t next = 0;
    std::size_t number = 0;  ///< of the chunk, which decides between equal times
  };
  struct Later {
    bool operator()(const OpenChunk* a, const OpenChunk* b) const;
  };
  class Collector;

  void start();
  void open_chunks();
  void open(Chunk& chunk);
  void close(OpenChunk* chunk);

  std::unique_ptr<BagFile> file_;
  std::unique_ptr<ChunkFormat> chunk_format_;
  BagLayout layout_;
  ChunkLoader loader_;
  std::string format_;
  std::vector<char> wanted_;  ///< for each topic
  bool is_started_ = false;
  std::size_t next_chunk_ = 0;
  std::vector<std::unique_ptr<OpenChunk>> all_;
  std::vector<OpenChunk*> free_;
  std::priority_queue<OpenChunk*, std::vector<OpenChunk*>, Later> open_;
  OpenChunk* current_ = nullptr;  ///< has the bytes that `next` returned last
  std::uint64_t held_bytes_ = 0;
  std::uint64_t read_bytes_ = 0;
  std::uint64_t total_bytes_ = 0;
  std::int64_t last_time_ns_ = std::numeric_limits<std::int64_t>::min();
};

}  // namespace roomatlas::io
