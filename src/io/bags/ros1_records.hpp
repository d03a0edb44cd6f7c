// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "chunk.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace roomatlas::io {

/// What a record of a ROS 1 bag is, by its field `op`.
enum class Ros1Op : std::uint8_t {
  message = 2,
  bag_header = 3,
  index = 4,
  chunk = 5,
  chunk_info = 6,
  connection = 7,
};

/// The fields of a record's header, or of a connection's data: `name=value`, each behind its
/// length. Views into the bytes that it was made from.
class Ros1Fields {
 public:
  /// Throws DamagedData.
  explicit Ros1Fields(ByteSpan header);

  [[nodiscard]] std::optional<ByteSpan> find(std::string_view name) const;
  /// These throw DamagedData where the field is missing or has another length.
  [[nodiscard]] ByteSpan bytes(std::string_view name, std::size_t size) const;
  [[nodiscard]] std::uint32_t u32(std::string_view name) const;
  [[nodiscard]] std::uint64_t u64(std::string_view name) const;
  [[nodiscard]] std::int64_t time_ns(std::string_view name) const;
  [[nodiscard]] Ros1Op op() const;
  /// Empty where it is missing.
  [[nodiscard]] std::string_view text(std::string_view name) const;

 private:
  struct Field {
    std::string_view name;
    ByteSpan value;
  };
  static constexpr std::size_t kMostFields = 24;  // the format's records have up to 8
  std::array<Field, kMostFields> fields_;
  std::size_t count_ = 0;
};

/// Seconds and nanoseconds, 32 bits each.
[[nodiscard]] std::int64_t ros1_time_ns(ByteCursor& cursor);

/// A record's place in a file. `fields` are valid until the file is viewed again.
struct Ros1Record {
  Ros1Fields fields;
  std::uint64_t data_offset = 0;
  std::uint32_t data_bytes = 0;
  [[nodiscard]] std::uint64_t end() const { return data_offset + data_bytes; }
};

/// Throws DamagedData where no record's header lies at `offset`. Its data may end behind the file.
[[nodiscard]] Ros1Record read_ros1_record(BagFile& file, std::uint64_t offset);

/// The topic of a connection record. Throws DamagedData.
[[nodiscard]] BagTopic ros1_topic(std::string_view name, ByteSpan data);

/// The records of ROS 1 bags, version 2.0.
class Ros1Format final : public ChunkFormat {
 public:
  void visit(ByteSpan records, RecordVisitor& visitor) const override;
  void find_content(BagFile& file, Chunk& chunk) const override;
};

/// Completes `chunk` from its record.
void set_ros1_content(const Ros1Record& record, Chunk& chunk);

}  // namespace roomatlas::io
