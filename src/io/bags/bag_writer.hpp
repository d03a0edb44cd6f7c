// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bag_reader.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>

namespace roomatlas::io {

/// Writes a recording. The same calls give the same bytes. Messages may come in any order of times.
/// Every failure of the disk throws InputError.
class BagWriter {
 public:
  virtual ~BagWriter() = default;
  /// How messages have to be encoded: ROS 1 bags hold `ros1` alone, rosbag2 `cdr` alone, MCAP both.
  [[nodiscard]] virtual bool takes(BagEncoding encoding) const = 0;
  /// Returns the topic's index, for `write`; the type without "msg", as readers have it. The
  /// definition's text (with those of the types in it, each behind a line of "=" and one "MSG:
  /// type") may be empty. `topic.messages` is not used. Throws std::invalid_argument for an
  /// encoding that it does not take.
  virtual std::size_t add_topic(const BagTopic& topic) = 0;
  virtual void write(std::size_t topic, std::int64_t log_time_ns,
                     std::span<const std::byte> bytes) = 0;
  /// Writes indexes and renames the temporary file to its final name. Without it nothing is left
  /// behind.
  virtual void finish() = 0;
};

enum class BagContainer { ros1, mcap, sqlite };

/// By the name's end: ".bag", ".mcap", ".db3"; the folder of a rosbag2, with metadata.yaml, where
/// there is none or the name ends with "/". Nothing for another.
[[nodiscard]] std::optional<BagContainer> bag_container_of(const std::filesystem::path& path);

/// Chunks are packed by lz4 in ROS 1 bags, which all their readers know, and by zstd in MCAP;
/// rosbag2's SQLite is not packed. Throws InputError for another name's end, and where nothing can
/// be written.
[[nodiscard]] std::unique_ptr<BagWriter> create_bag(const std::filesystem::path& path);

}  // namespace roomatlas::io
