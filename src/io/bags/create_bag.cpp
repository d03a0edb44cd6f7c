// SPDX-License-Identifier: GPL-3.0-or-later
#include "bag_writers.hpp"

namespace roomatlas::io {

std::optional<BagContainer> bag_container_of(const std::filesystem::path& path) {
  const std::filesystem::path extension = path.extension();
  if (extension == ".bag") return BagContainer::ros1;
  if (extension == ".mcap") return BagContainer::mcap;
  if (extension == ".db3" || !path.has_filename() || extension.empty()) return BagContainer::sqlite;
  return std::nullopt;
}

std::unique_ptr<BagWriter> create_bag(const std::filesystem::path& path) {
  const auto container = bag_container_of(path);
  if (!container) {
    throw InputError(path.string() +
                     ": no recording is written under such a name; expected one that ends in .bag, "
                     ".mcap or .db3, or a folder's");
  }
  switch (*container) {
    case BagContainer::ros1:
      return create_ros1_bag(path, Packing::lz4);
    case BagContainer::mcap:
      return create_mcap(path);
    case BagContainer::sqlite:
      break;
  }
  return path.extension() == ".db3" ? create_sqlite_bag(path) : create_rosbag2_folder(path);
}

}  // namespace roomatlas::io
