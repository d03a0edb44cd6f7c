// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bag_writer.hpp"
#include "unpack.hpp"

#include <filesystem>
#include <memory>

namespace roomatlas::io {

/// Chunks of 768 KiB, as ROS's recorder has them, with an index. Not packed by zstd, which ROS 1
/// does not know.
[[nodiscard]] std::unique_ptr<BagWriter> create_ros1_bag(const std::filesystem::path& file,
                                                         Packing packing);
/// Chunks packed by zstd, with message indexes, CRCs and a summary.
[[nodiscard]] std::unique_ptr<BagWriter> create_mcap(const std::filesystem::path& file);
/// A file of rosbag2's SQLite storage.
[[nodiscard]] std::unique_ptr<BagWriter> create_sqlite_bag(const std::filesystem::path& file);
/// A folder with such a file and its metadata.yaml.
[[nodiscard]] std::unique_ptr<BagWriter> create_rosbag2_folder(const std::filesystem::path& folder);

}  // namespace roomatlas::io
