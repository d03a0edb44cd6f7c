// SPDX-License-Identifier: GPL-3.0-or-later
#include "ros1_bag.hpp"

#include "chunked_reader.hpp"
#include "ros1_records.hpp"

#include <algorithm>
#include <utility>

namespace roomatlas::io {
namespace {

constexpr std::string_view kMagic = "#ROSBAG V2.0\n";
constexpr std::size_t kLongestConnection_bytes = std::size_t{1} << 24;

struct BagHeader {
  std::uint64_t index_offset = 0;  ///< 0: no index was written
  std::uint32_t connections = 0;
  std::uint32_t chunks = 0;
  std::uint64_t end = 0;
};

BagHeader read_bag_header(BagFile& file) {
  try {
    const Ros1Record record = read_ros1_record(file, kMagic.size());
    if (record.fields.op() != Ros1Op::bag_header) throw DamagedData("its first record is another");
    if (!record.fields.text("encryptor").empty()) {
      throw InputError(file.name() +
                       ": is an encrypted ROS 1 bag; expected one in the clear: decrypt it with "
                       "`rosbag decompress` where its key is");
    }
    return {record.fields.u64("index_pos"), record.fields.u32("conn_count"),
            record.fields.u32("chunk_count"), record.end()};
  } catch (const DamagedData& damage) {
    throw InputError(file.name() + ": is a ROS 1 bag without a whole header (" + damage.what() +
                     "); nothing in it can be read: copy the file again");
  }
}

/// The record's data. The views of its header are lost by it.
ByteSpan data_of(BagFile& file, const Ros1Record& record, std::size_t most_bytes) {
  if (record.data_bytes > most_bytes) throw DamagedData("a record is too long");
  const ByteSpan data = file.view(record.data_offset, record.data_bytes);
  if (data.size() < record.data_bytes) throw DamagedData("the file ends inside a record");
  return data;
}

void add_connection(BagFile& file, const Ros1Record& record, TopicTable& topics) {
  const std::uint32_t connection = record.fields.u32("conn");
  const std::string name(record.fields.text("topic"));
  const ByteSpan data = data_of(file, record, kLongestConnection_bytes);
  topics.connect(connection, ros1_topic(name, data));
}

Chunk chunk_of_info(BagFile& file, const Ros1Record& record) {
  if (record.fields.u32("ver") != 1) throw DamagedData("its index has another version");
  Chunk chunk;
  chunk.header_offset = record.fields.u64("chunk_pos");
  chunk.start_ns = record.fields.time_ns("start_time");
  chunk.end_ns = record.fields.time_ns("end_time");
  chunk.content_is_known = false;
  chunk.messages_are_known = true;
  if (chunk.header_offset >= file.size()) throw DamagedData("a chunk lies behind the file's end");
  for (ByteCursor cursor(data_of(file, record, record.data_bytes)); !cursor.at_end();) {
    const std::uint32_t connection = cursor.u32();
    chunk.messages.push_back({connection, cursor.u32()});
  }
  return chunk;
}

/// Reads the index at the file's end. Throws DamagedData where it is not whole.
void read_index(BagFile& file, const BagHeader& header, BagLayout& layout) {
  for (std::uint64_t offset = header.index_offset; offset < file.size();) {
    const Ros1Record record = read_ros1_record(file, offset);
    offset = record.end();
    const Ros1Op op = record.fields.op();
    if (op == Ros1Op::connection) {
      add_connection(file, record, layout.topics);
    } else if (op == Ros1Op::chunk_info) {
      layout.chunks.push_back(chunk_of_info(file, record));
    }
  }
  if (layout.chunks.size() != header.chunks) throw DamagedData("its index is not complete");
  for (const Chunk& chunk : layout.chunks) {
    for (const ConnectionCount& of : chunk.messages) {
      if (!layout.topics.knows(of.connection)) throw DamagedData("its index lacks a connection");
      layout.topics.count(of.connection, of.messages);
    }
  }
}

/// Whether a message lies between two places of the file, outside of the chunks.
bool has_message(BagFile& file, std::uint64_t from, std::uint64_t to) {
  while (from < to) {
    const Ros1Record record = read_ros1_record(file, from);
    if (record.fields.op() == Ros1Op::message) return true;
    from = record.end();
  }
  return false;
}

/// Whether there are messages of which the index does not tell, since no chunk holds them. A bag
/// that has such has them all along: of one with many chunks some gaps between these are looked at.
bool has_open_messages(BagFile& file, const BagHeader& header, const BagLayout& layout) {
  constexpr std::size_t kMostGaps = 1024;
  std::vector<std::uint64_t> places;
  for (const Chunk& chunk : layout.chunks) places.push_back(chunk.header_offset);
  std::sort(places.begin(), places.end());
  places.push_back(header.index_offset);
  try {
    if (has_message(file, header.end, places.front())) return true;
    const std::size_t step = 1 + (places.size() - 2) / kMostGaps;
    for (std::size_t i = 0; i + 1 < places.size(); i += step) {
      const std::uint64_t chunk_end = read_ros1_record(file, places[i]).end();
      if (has_message(file, chunk_end, places[i + 1])) return true;
    }
  } catch (const DamagedData&) {  // it is met again, and said, where it is read
  }
  return false;
}

/// Finds what is where in a file without an index, record by record.
class Pass {
 public:
  Pass(BagFile& file, BagLayout& layout) : file_(file), layout_(layout), loader_(file) {}

  void run(std::uint64_t offset) {
    try {
      while (offset < file_.size()) offset = take(offset);
    } catch (const DamagedData& damage) {
      layout_.issues.add(Severity::warning,
                         "it is cut short or damaged at byte " + std::to_string(offset) + " (" +
                             damage.what() + "): what is behind it was left out",
                         "bytes", static_cast<std::int64_t>(file_.size() - offset));
    }
    finish_chunk();
  }

 private:
  /// Returns where the next record begins.
  std::uint64_t take(std::uint64_t offset) {
    const Ros1Record record = read_ros1_record(file_, offset);
    const Ros1Op op = record.fields.op();
    const std::uint64_t end = record.end();
    if (op != Ros1Op::index) finish_chunk();
    if (op == Ros1Op::chunk) {
      Chunk chunk;
      chunk.header_offset = offset;
      set_ros1_content(record, chunk);
      layout_.chunks.push_back(std::move(chunk));
      chunk_is_open_ = true;
      return end;  // may lie behind the file: what is whole of it is read
    }
    if (end > file_.size()) throw DamagedData("the file ends inside a record");
    if (op == Ros1Op::index && chunk_is_open_) {
      add_index(record);
    } else if (op == Ros1Op::connection) {
      add_connection(file_, record, layout_.topics);
    } else if (op == Ros1Op::message) {
      add_open_message(layout_, offset, end, record.fields.u32("conn"),
                       record.fields.time_ns("time"));
    }
    return end;
  }

  /// What one connection has in the chunk before.
  void add_index(const Ros1Record& record) {
    if (record.fields.u32("ver") != 1) return;
    Chunk& chunk = layout_.chunks.back();
    const std::uint32_t connection = record.fields.u32("conn");
    std::uint32_t messages = 0;
    constexpr std::size_t kEntry_bytes = 12;
    for (std::uint64_t at = record.data_offset; at + kEntry_bytes <= record.end();) {
      ByteCursor cursor(file_.view(at, kEntry_bytes));
      const std::int64_t time_ns = ros1_time_ns(cursor);
      const bool is_first = chunk.messages.empty() && messages == 0;
      chunk.start_ns = is_first ? time_ns : std::min(chunk.start_ns, time_ns);
      chunk.end_ns = is_first ? time_ns : std::max(chunk.end_ns, time_ns);
      ++messages;
      at += kEntry_bytes;
    }
    chunk.messages.push_back({connection, messages});
  }

  void finish_chunk() {
    if (!std::exchange(chunk_is_open_, false)) return;
    count_indexed(layout_.chunks.back(), format_, loader_, layout_);
  }

  BagFile& file_;
  BagLayout& layout_;
  Ros1Format format_;
  ChunkLoader loader_;
  bool chunk_is_open_ = false;
};

BagLayout empty_layout(const BagFile& file) {
  BagLayout layout(file.name());
  layout.container = "ROS 1 bag 2.0";
  return layout;
}

BagLayout layout_of(BagFile& file) {
  const BagHeader header = read_bag_header(file);
  BagLayout layout = empty_layout(file);
  std::string why;
  bool has_open = false;
  if (header.index_offset != 0 && header.chunks > 0) {
    try {
      read_index(file, header, layout);
      // Its packing is what people are told; the others are looked up when it is their turn.
      Ros1Format().find_content(file, layout.chunks.front());
      has_open = has_open_messages(file, header, layout);
      if (!has_open) return layout;
    } catch (const DamagedData& damage) {
      why = damage.what();
    }
  }
  layout = empty_layout(file);
  Pass(file, layout).run(header.end);
  if (!why.empty()) {
    layout.issues.add(Severity::warning, "its index is damaged (" + why + "): it was read without");
  } else if (has_open) {
    layout.issues.add(Severity::note,
                      "it has messages outside of its chunks, of which its index does not tell: it "
                      "was read without");
  } else if (header.index_offset == 0) {
    layout.issues.add(Severity::note,
                      "it has no index, since its recording was not closed: it was read without");
  }
  return layout;
}

}  // namespace

bool is_ros1_bag(std::string_view beginning) {
  return beginning.starts_with("#ROSBAG V") || beginning.starts_with("#ROSRECORD V");
}

std::unique_ptr<BagReader> open_ros1_bag(std::unique_ptr<BagFile> file) {
  const std::string_view beginning = as_text(file->view(0, kMagic.size()));
  if (beginning != kMagic) {
    const std::string found(beginning.substr(0, beginning.find('\n')));
    throw InputError(file->name() + ": is a ROS 1 bag of another version (" + found +
                     "); expected #ROSBAG V2.0: convert it with `rosbag fix`");
  }
  BagLayout layout = layout_of(*file);
  require_topics(layout, file->name());
  return std::make_unique<ChunkedReader>(std::move(file), std::make_unique<Ros1Format>(),
                                         std::move(layout));
}

}  // namespace roomatlas::io
