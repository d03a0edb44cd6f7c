// SPDX-License-Identifier: GPL-3.0-or-later
#include "bag_writers.hpp"
#include "byte_text.hpp"
#include "crc32.hpp"
#include "files/output_file.hpp"
#include "mcap_records.hpp"
#include "pack.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <stdexcept>
#include <utility>

namespace roomatlas::io {
namespace {

constexpr std::size_t kChunk_bytes = std::size_t{1} << 20;  // what readers unpack at once

std::uint32_t crc_of(std::string_view text, std::uint32_t before = 0) {
  return crc32_of(std::as_bytes(std::span(text)), before);
}

std::string record(McapOp op, const ByteText& content) {
  ByteText text;
  text.u8(static_cast<std::uint8_t>(op));
  text.u64(content.size());
  text.append(content.text());
  return text.text();
}

std::uint64_t bits(std::int64_t time_ns) {
  return static_cast<std::uint64_t>(std::max<std::int64_t>(0, time_ns));
}

class McapWriter final : public BagWriter {
 public:
  explicit McapWriter(const std::filesystem::path& file) : output_(file) { put(kMcapMagic); }

  [[nodiscard]] bool takes(BagEncoding encoding) const override {
    return encoding != BagEncoding::other;
  }

  std::size_t add_topic(const BagTopic& topic) override {
    if (!takes(topic.encoding)) throw std::invalid_argument("an encoding that is not written");
    if (topics_ == 0xffff) throw std::invalid_argument("more topics than MCAP can hold");
    const bool is_ros1 = topic.encoding == BagEncoding::ros1;
    start(is_ros1 ? "ros1" : "ros2");
    const std::size_t slash = topic.type.find('/');
    std::string type = topic.type;
    if (!is_ros1 && slash != std::string::npos) type.insert(slash, "/msg");
    ByteText schema;
    schema.block(type);
    schema.block(is_ros1 ? "ros1msg" : "ros2msg");
    schema.block(topic.definition);
    const auto [known, is_new] =
        schemas_.emplace(schema.text(), static_cast<std::uint16_t>(schemas_.size() + 1));
    if (is_new) {
      ByteText content;
      content.u16(known->second);
      content.append(schema.text());
      describe(record(McapOp::schema, content));
    }
    ByteText channel;
    channel.u16(++topics_);
    channel.u16(known->second);
    channel.block(topic.name);
    channel.block(is_ros1 ? "ros1" : "cdr");
    channel.u32(0);
    describe(record(McapOp::channel, channel));
    counts_.push_back(0);
    return topics_ - 1U;
  }

  void write(std::size_t topic, std::int64_t log_time_ns,
             std::span<const std::byte> bytes) override {
    const auto channel = static_cast<std::uint16_t>(topic + 1);
    const std::uint64_t time = bits(log_time_ns);
    places_[channel].emplace_back(time, chunk_.size());
    chunk_start_ = std::min(chunk_start_, time);
    chunk_end_ = std::max(chunk_end_, time);
    chunk_.u8(static_cast<std::uint8_t>(McapOp::message));
    chunk_.u64(2 + 4 + 8 + 8 + bytes.size());
    chunk_.u16(channel);
    chunk_.u32(static_cast<std::uint32_t>(counts_.at(topic)++));
    chunk_.u64(time);
    chunk_.u64(time);
    chunk_.append(bytes);
    if (chunk_.size() >= kChunk_bytes) finish_chunk();
  }

  void finish() override {
    start("");
    finish_chunk();
    ByteText data_end;
    data_end.u32(crc_);
    put(record(McapOp::data_end, data_end));
    const std::uint64_t summary_start = offset_;
    const std::string summary = descriptions_ + record(McapOp::statistics, statistics()) + index_;
    ByteText footer;
    footer.u64(summary_start);
    footer.u64(0);
    ByteText summed;
    summed.append(summary);
    summed.u8(static_cast<std::uint8_t>(McapOp::footer));
    summed.u64(footer.size() + 4);
    summed.append(footer.text());
    footer.u32(crc_of(summed.text()));
    put(summary);
    put(record(McapOp::footer, footer));
    put(kMcapMagic);
    output_.commit();
  }

 private:
  void put(std::string_view bytes) {
    output_.write(bytes);
    offset_ += bytes.size();
    crc_ = crc_of(bytes, crc_);
  }

  void start(const char* profile) {
    if (std::exchange(is_started_, true)) return;
    ByteText header;
    header.block(profile);
    header.block("roomatlas");
    put(record(McapOp::header, header));
  }

  void describe(const std::string& description) {
    chunk_.append(description);
    descriptions_ += description;
  }

  void finish_chunk() {
    if (chunk_.size() == 0) return;
    const std::uint64_t start = places_.empty() ? 0 : chunk_start_;
    const std::string packed = pack(Packing::zstd, chunk_.text());
    ByteText content;
    content.u64(start);
    content.u64(chunk_end_);
    content.u64(chunk_.size());
    content.u32(crc_of(chunk_.text()));
    content.block(name_of(Packing::zstd));
    content.u64(packed.size());
    content.append(packed);
    const std::uint64_t offset = offset_;
    put(record(McapOp::chunk, content));
    const std::uint64_t bytes = offset_ - offset;
    const ByteText places = put_message_indexes();
    ByteText index;
    index.u64(start);
    index.u64(chunk_end_);
    index.u64(offset);
    index.u64(bytes);
    index.block(places.text());
    index.u64(offset_ - offset - bytes);
    index.block(name_of(Packing::zstd));
    index.u64(packed.size());
    index.u64(chunk_.size());
    index_ += record(McapOp::chunk_index, index);
    start_ = std::min(start_, places_.empty() ? start_ : start);
    end_ = std::max(end_, chunk_end_);
    ++chunks_;
    chunk_.clear();
    places_.clear();
    chunk_start_ = ~std::uint64_t{0};
    chunk_end_ = 0;
  }

  /// Returns where each channel's index lies.
  ByteText put_message_indexes() {
    ByteText places;
    for (const auto& [channel, entries] : places_) {
      places.u16(channel);
      places.u64(offset_);
      ByteText array;
      for (const auto& [time, place] : entries) {
        array.u64(time);
        array.u64(place);
      }
      ByteText index;
      index.u16(channel);
      index.block(array.text());
      put(record(McapOp::message_index, index));
    }
    return places;
  }

  [[nodiscard]] ByteText statistics() const {
    ByteText counts;
    std::uint64_t messages = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      counts.u16(static_cast<std::uint16_t>(i + 1));
      counts.u64(counts_[i]);
      messages += counts_[i];
    }
    ByteText text;
    text.u64(messages);
    text.u16(static_cast<std::uint16_t>(schemas_.size()));
    text.u32(topics_);
    text.u32(0);  // attachments
    text.u32(0);  // metadata
    text.u32(chunks_);
    text.u64(messages > 0 ? start_ : 0);
    text.u64(end_);
    text.block(counts.text());
    return text;
  }

  OutputFile output_;
  std::uint64_t offset_ = 0;
  std::uint32_t crc_ = 0;  ///< of all that is written
  bool is_started_ = false;
  std::map<std::string, std::uint16_t> schemas_;
  std::uint16_t topics_ = 0;
  std::vector<std::uint64_t> counts_;  ///< messages of each topic
  std::string descriptions_;           ///< schemas and channels, for the summary
  std::string index_;
  std::uint32_t chunks_ = 0;
  std::uint64_t start_ = ~std::uint64_t{0};
  std::uint64_t end_ = 0;
  ByteText chunk_;
  std::map<std::uint16_t, std::vector<std::pair<std::uint64_t, std::uint64_t>>> places_;
  std::uint64_t chunk_start_ = ~std::uint64_t{0};
  std::uint64_t chunk_end_ = 0;
};

}  // namespace

std::unique_ptr<BagWriter> create_mcap(const std::filesystem::path& file) {
  return std::make_unique<McapWriter>(file);
}

}  // namespace roomatlas::io
