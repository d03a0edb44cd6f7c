// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bag_file.hpp"
#include "bag_issues.hpp"
#include "topic_table.hpp"
#include "unpack.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace roomatlas::io {

/// A larger one is left out: no recorder makes such, a damaged length does.
inline constexpr std::uint64_t kLargestChunk_bytes = std::uint64_t{1} << 30;
/// Messages that lie in the file unpacked are taken in stretches of about this size.
inline constexpr std::uint64_t kStretch_bytes = std::uint64_t{1} << 20;
/// A message that lies in the file unpacked and is larger is a stretch of its own: it is skipped
/// alone.
inline constexpr std::uint64_t kOwnStretch_bytes = std::uint64_t{1} << 16;

struct ConnectionCount {
  std::uint32_t connection = 0;
  std::uint32_t messages = 0;
};

/// A stretch of a file with messages: a chunk's content, or records that lie in the file openly.
struct Chunk {
  std::uint64_t header_offset =
      0;                     ///< of its record; where `content_is_known` is false, all there is
  std::uint64_t offset = 0;  ///< of its packed content
  std::uint64_t packed_bytes = 0;
  std::uint64_t unpacked_bytes = 0;
  std::string packing;    ///< by the container's name for it; empty: not packed
  std::uint32_t crc = 0;  ///< CRC-32 of the unpacked content; 0 where there is none
  std::int64_t start_ns = 0;
  std::int64_t end_ns = 0;
  bool content_is_known = true;     ///< else the reader asks the format for it when it is its turn
  bool messages_are_known = false;  ///< `messages` is true
  std::vector<ConnectionCount> messages;
};

/// Who is told what lies in a chunk.
class RecordVisitor {
 public:
  virtual ~RecordVisitor() = default;
  virtual void connection(std::uint32_t connection, BagTopic topic) = 0;
  virtual void message(std::uint32_t connection, std::int64_t log_time_ns, ByteSpan bytes) = 0;
};

/// What differs between the containers that have chunks.
class ChunkFormat {
 public:
  virtual ~ChunkFormat() = default;
  /// Tells `visitor` what `records` hold, in their order. Throws DamagedData where they end early
  /// or are not records; what came before has been told.
  virtual void visit(ByteSpan records, RecordVisitor& visitor) const = 0;
  /// Completes a chunk of which only `header_offset` is known. Throws DamagedData.
  virtual void find_content(BagFile& file, Chunk& chunk) const = 0;
};

/// What a pass over a recording's index, or over the headers of its records, found.
struct BagLayout {
  explicit BagLayout(const std::string& file) : issues(file) {}

  std::string container;  ///< "MCAP"
  TopicTable topics;
  std::vector<Chunk> chunks;  ///< in the file's order
  BagIssues issues;
  std::string first_fault;  ///< of a chunk that had to be unpacked to learn what is in it
};

/// Throws InputError where no topic was found: nothing in the file can be read.
void require_topics(const BagLayout& layout, const std::string& file);

/// Unpacks chunks, and keeps what it needs for the next one.
class ChunkLoader {
 public:
  explicit ChunkLoader(BagFile& file) : file_(file) {}

  /// Fills `content` with the chunk's records. Returns what is wrong, for people, empty where all
  /// is well; `content` has then what is whole before the fault, or nothing.
  [[nodiscard]] std::string load(const Chunk& chunk, Buffer& content);

 private:
  BagFile& file_;
  std::uint64_t unpacked_bytes_ = 0;  ///< of all chunks so far
  Unpacker unpacker_;
  Buffer packed_;
};

/// Learns from a chunk itself which connections and messages are in it, and from when to when.
void take_inventory(Chunk& chunk, const ChunkFormat& format, ChunkLoader& loader,
                    BagLayout& layout);

/// Counts a chunk's messages as its index has them. One without an index, or with connections that
/// are described in it alone, is unpacked.
void count_indexed(Chunk& chunk, const ChunkFormat& format, ChunkLoader& loader, BagLayout& layout);

/// Puts a message that lies openly in the file, from `begin` to `end`, into the last stretch or a
/// new one.
void add_open_message(BagLayout& layout, std::uint64_t begin, std::uint64_t end,
                      std::uint32_t connection, std::int64_t log_time_ns);

}  // namespace roomatlas::io
