// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bag_file.hpp"
#include "bag_reader.hpp"

#include <memory>
#include <string_view>

namespace roomatlas::io {

/// Whether a file that begins so is a ROS 1 bag, of whatever version.
[[nodiscard]] bool is_ros1_bag(std::string_view beginning);

/// Reads a ROS 1 bag, version 2.0: by its index, or where there is none, or a damaged one, by a
/// pass over the headers of its records. Throws InputError for other versions, encrypted bags, and
/// where no record is whole.
[[nodiscard]] std::unique_ptr<BagReader> open_ros1_bag(std::unique_ptr<BagFile> file);

}  // namespace roomatlas::io
