// SPDX-License-Identifier: GPL-3.0-or-later
#include "bag_writers.hpp"
#include "byte_text.hpp"
#include "files/output_file.hpp"
#include "pack.hpp"
#include "ros1_md5.hpp"
#include "ros1_records.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace roomatlas::io {
namespace {

constexpr std::string_view kMagic = "#ROSBAG V2.0\n";
constexpr std::size_t kChunk_bytes = std::size_t{768} * 1024;
constexpr std::size_t kBagHeader_bytes = 4096;  // with its padding; so that it can be written again

/// The fields of a header.
class Header {
 public:
  explicit Header(Ros1Op op) { field("op", std::string(1, static_cast<char>(op))); }
  Header& field(std::string_view name, std::string_view value) {
    text_.u32(static_cast<std::uint32_t>(name.size() + 1 + value.size()));
    text_.append(name);
    text_.append("=");
    text_.append(value);
    return *this;
  }
  Header& u32(std::string_view name, std::size_t value) {
    ByteText text;
    text.u32(static_cast<std::uint32_t>(value));
    return field(name, text.text());
  }
  Header& u64(std::string_view name, std::uint64_t value) {
    ByteText text;
    text.u64(value);
    return field(name, text.text());
  }
  Header& time(std::string_view name, std::int64_t time_ns);
  [[nodiscard]] const std::string& text() const { return text_.text(); }

 private:
  ByteText text_;
};

void append_time(ByteText& text, std::int64_t time_ns) {
  constexpr std::int64_t kSecond_ns = 1'000'000'000;
  time_ns = std::max<std::int64_t>(0, time_ns);
  text.u32(static_cast<std::uint32_t>(time_ns / kSecond_ns));
  text.u32(static_cast<std::uint32_t>(time_ns % kSecond_ns));
}

Header& Header::time(std::string_view name, std::int64_t time_ns) {
  ByteText text;
  append_time(text, time_ns);
  return field(name, text.text());
}

std::string record(const Header& header, std::string_view data) {
  ByteText text;
  text.block(header.text());
  text.block(data);
  return text.text();
}

std::string fields(const std::vector<std::pair<std::string, std::string>>& named) {
  ByteText text;
  for (const auto& [name, value] : named) text.block(name + "=" + value);
  return text.text();
}

class Ros1Writer final : public BagWriter {
 public:
  Ros1Writer(const std::filesystem::path& file, Packing packing)
      : output_(file), packing_(packing) {
    put(kMagic);
    put(bag_header(0));
  }

  [[nodiscard]] bool takes(BagEncoding encoding) const override {
    return encoding == BagEncoding::ros1;
  }

  std::size_t add_topic(const BagTopic& topic) override {
    if (!takes(topic.encoding))
      throw std::invalid_argument("a ROS 1 bag holds ROS 1 messages alone");
    const Header header =
        Header(Ros1Op::connection).u32("conn", connections_.size()).field("topic", topic.name);
    connections_.push_back(
        record(header, fields({{"topic", topic.name},
                               {"type", topic.type},
                               {"md5sum", ros1_md5(topic.type, topic.definition)},
                               {"message_definition", topic.definition}})));
    is_described_.push_back(0);
    return connections_.size() - 1;
  }

  void write(std::size_t topic, std::int64_t log_time_ns,
             std::span<const std::byte> bytes) override {
    if (!std::exchange(is_described_.at(topic), char{1})) chunk_.append(connections_[topic]);
    places_[topic].emplace_back(log_time_ns, chunk_.size());
    const Header header = Header(Ros1Op::message).u32("conn", topic).time("time", log_time_ns);
    chunk_.block(header.text());
    chunk_.u32(static_cast<std::uint32_t>(bytes.size()));
    chunk_.append(bytes);
    start_ns_ = std::min(start_ns_, log_time_ns);
    end_ns_ = std::max(end_ns_, log_time_ns);
    if (chunk_.size() >= kChunk_bytes) finish_chunk();
  }

  void finish() override {
    finish_chunk();
    const std::uint64_t index = offset_;
    for (const std::string& connection : connections_) put(connection);
    put(infos_);
    output_.overwrite(kMagic.size(), bag_header(index));
    output_.commit();
  }

 private:
  void put(std::string_view bytes) {
    output_.write(bytes);
    offset_ += bytes.size();
  }

  [[nodiscard]] std::string bag_header(std::uint64_t index) const {
    const Header header = Header(Ros1Op::bag_header)
                              .u64("index_pos", index)
                              .u32("conn_count", connections_.size())
                              .u32("chunk_count", chunks_);
    return record(header, std::string(kBagHeader_bytes - 8 - header.text().size(), ' '));
  }

  void finish_chunk() {
    if (places_.empty()) return;
    ByteText counts;
    for (const auto& [topic, entries] : places_) {
      counts.u32(static_cast<std::uint32_t>(topic));
      counts.u32(static_cast<std::uint32_t>(entries.size()));
    }
    infos_ += record(Header(Ros1Op::chunk_info)
                         .u32("ver", 1)
                         .u64("chunk_pos", offset_)
                         .time("start_time", start_ns_)
                         .time("end_time", end_ns_)
                         .u32("count", places_.size()),
                     counts.text());
    const std::string_view packing = packing_ == Packing::none ? "none" : name_of(packing_);
    put(record(Header(Ros1Op::chunk).field("compression", packing).u32("size", chunk_.size()),
               pack(packing_, chunk_.text())));
    for (const auto& [topic, entries] : places_) {
      ByteText index;
      for (const auto& [time_ns, place] : entries) {
        append_time(index, time_ns);
        index.u32(static_cast<std::uint32_t>(place));
      }
      put(record(
          Header(Ros1Op::index).u32("ver", 1).u32("conn", topic).u32("count", entries.size()),
          index.text()));
    }
    ++chunks_;
    chunk_.clear();
    places_.clear();
    start_ns_ = std::numeric_limits<std::int64_t>::max();
    end_ns_ = 0;
  }

  OutputFile output_;
  Packing packing_;
  std::uint64_t offset_ = 0;
  std::vector<std::string> connections_;  ///< their records
  std::vector<char> is_described_;        ///< in a chunk
  std::size_t chunks_ = 0;
  std::string infos_;
  ByteText chunk_;
  std::map<std::size_t, std::vector<std::pair<std::int64_t, std::size_t>>> places_;
  std::int64_t start_ns_ = std::numeric_limits<std::int64_t>::max();
  std::int64_t end_ns_ = 0;
};

}  // namespace

std::unique_ptr<BagWriter> create_ros1_bag(const std::filesystem::path& file, Packing packing) {
  if (packing == Packing::zstd) throw std::invalid_argument("ROS 1 bags are not packed by zstd");
  return std::make_unique<Ros1Writer>(file, packing);
}

}  // namespace roomatlas::io
