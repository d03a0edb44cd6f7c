// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bag_reader.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace roomatlas::io {

inline constexpr const char* kRosbag2MetadataName = "metadata.yaml";

/// What is used of a rosbag2's metadata.yaml. How its files are stored and packed, the files say
/// themselves.
struct Rosbag2Metadata {
  std::vector<std::string> files;  ///< in order, as they stand there
  std::string compression_format;  ///< "zstd"; empty where nothing is packed
  std::vector<BagTopic> topics;    ///< with their counts
};

/// Reads the lines that are used, wherever in the file they stand; others are passed over. Nothing
/// where the file is missing or is not of a rosbag2.
[[nodiscard]] std::optional<Rosbag2Metadata> read_rosbag2_metadata(
    const std::filesystem::path& folder);

}  // namespace roomatlas::io
