// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "roomatlas/core/issue.hpp"

namespace roomatlas::io {

/// How a recorded message's bytes are laid out.
enum class BagEncoding { ros1, cdr, other };

/// A stream of messages of one type in a recording. Topics of one name but other types, or from
/// several publishers (ROS 1 connections, MCAP channels), are merged where name, type and encoding
/// are the same.
struct BagTopic {
  std::string name;  ///< "/scan"
  std::string type;  ///< "sensor_msgs/LaserScan": package and name, whatever the ROS release
  BagEncoding encoding = BagEncoding::other;
  std::string definition;  ///< text of the message definition; empty where the recording has none
  std::optional<std::int64_t> messages;  ///< where an index says so, before they are read
};

/// The latest time of recording that is told, where ROS 1's 32 bits of seconds end (2106). Readers
/// hold theirs between 0 and it: sums and differences of damaged times then are numbers, too.
inline constexpr std::int64_t kLatestTime_ns = 4'294'967'300'000'000'000;

/// One message, as recorded.
struct BagMessage {
  std::size_t topic = 0;             ///< index into `topics()`
  std::int64_t log_time_ns = 0;      ///< when the recorder received it: 0 to `kLatestTime_ns`
  std::span<const std::byte> bytes;  ///< valid until the next call of `next`
};

/// A recording, streaming: ROS 1 bag, rosbag2 with SQLite storage, MCAP. Memory does not grow with
/// its length: the largest piece that is held is one chunk.
class BagReader {
 public:
  virtual ~BagReader() = default;
  /// What the container is, for people: "ROS 1 bag 2.0 (lz4)", "rosbag2 (SQLite, zstd)", "MCAP
  /// (zstd)".
  [[nodiscard]] virtual const std::string& format() const = 0;
  /// Known so far; grows, never reorders. Complete after opening where there is an index or
  /// summary, else a first pass over the records' headers makes it so.
  [[nodiscard]] virtual const std::vector<BagTopic>& topics() const = 0;
  /// Only messages of these topics are wanted; others are skipped, by index where there is one, so
  /// that chunks without them are neither read nor unpacked. Before the first `next`.
  virtual void select(const std::vector<std::size_t>& topics) = 0;
  /// The next message in the order of log times where an index allows it, else in file order;
  /// nothing at the end. What cannot be read is left out, counted and said in `issues`.
  [[nodiscard]] virtual std::optional<BagMessage> next() = 0;
  /// What was odd: cut short, wrong CRC, unknown compression ... each kind once, with its count.
  [[nodiscard]] virtual Issues issues() const = 0;
  [[nodiscard]] virtual double progress() const = 0;  ///< share of the recording consumed, [0, 1]
};

/// Opens a recording, told by its content, not its name: a file, or the folder of a rosbag2.
/// Returns null when it is none of the known containers. Throws InputError naming the file, what
/// was expected and the remedy when it is one and nothing in it can be read.
[[nodiscard]] std::unique_ptr<BagReader> open_bag(const std::filesystem::path& path);

/// Whether a file's first bytes say that it is a ROS 1 bag or MCAP; of others they say too little.
/// Throws InputError where it cannot be read.
[[nodiscard]] bool is_bag_by_magic(const std::filesystem::path& file);

}  // namespace roomatlas::io
