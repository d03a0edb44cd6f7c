// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bag_reader.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace roomatlas::io {

/// The same recording with its CDR messages unpacked where each is packed by zstd for itself, as
/// rosbag2 can do.
[[nodiscard]] std::unique_ptr<BagReader> with_messages_unpacked(std::unique_ptr<BagReader> bag);

/// The same recording, called otherwise, with more to say about it.
[[nodiscard]] std::unique_ptr<BagReader> with_remarks(std::unique_ptr<BagReader> bag,
                                                      std::string format, Issues issues);

/// A file of a recording that goes on in others.
struct BagPart {
  std::filesystem::path file;
  std::uint64_t bytes = 0;
};

/// One recording of several files, one after another; one is open at a time. Throws InputError
/// where none can be read; those that cannot are left out and said. `known` are topics that need
/// not be looked up in each file, empty where they must be; their counts are taken over where
/// `known` or all files have them.
[[nodiscard]] std::unique_ptr<BagReader> in_sequence(
    const std::string& name, std::vector<BagPart> parts, std::vector<BagTopic> known,
    bool look_into_all,
    std::function<std::unique_ptr<BagReader>(const std::filesystem::path&)> open);

}  // namespace roomatlas::io
