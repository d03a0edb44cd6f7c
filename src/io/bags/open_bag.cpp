// SPDX-License-Identifier: GPL-3.0-or-later
#include "bag_reader.hpp"
#include "mcap_bag.hpp"
#include "mcap_records.hpp"
#include "ros1_bag.hpp"

namespace roomatlas::io {

std::unique_ptr<BagReader> open_bag(const std::filesystem::path& path) {
  auto file = std::make_unique<BagFile>(path);
  const std::string beginning(as_text(file->view(0, 16)));
  if (is_ros1_bag(beginning)) return open_ros1_bag(std::move(file));
  if (beginning.starts_with(kMcapMagic)) return open_mcap(std::move(file));
  return nullptr;
}

}  // namespace roomatlas::io
