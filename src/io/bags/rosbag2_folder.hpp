// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bag_reader.hpp"

#include <filesystem>
#include <functional>
#include <memory>

namespace roomatlas::io {

/// Reads the folder of a rosbag2: the files that its metadata.yaml names, in that order, or,
/// without it, those that are recordings, in the order of their numbers. `open` opens one of them.
/// Returns null where it is another folder. Throws InputError where it holds several recordings.
[[nodiscard]] std::unique_ptr<BagReader> open_rosbag2_folder(
    const std::filesystem::path& folder,
    const std::function<std::unique_ptr<BagReader>(const std::filesystem::path&)>& open);

}  // namespace roomatlas::io
