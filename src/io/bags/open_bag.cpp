// SPDX-License-Identifier: GPL-3.0-or-later
#include "bag_reader.hpp"
#include "mcap_bag.hpp"
#include "mcap_records.hpp"
#include "ros1_bag.hpp"
#include "rosbag2_folder.hpp"
#include "sqlite_bag.hpp"
#include "unpack.hpp"
#include "unpack_file.hpp"
#include "wrapped_readers.hpp"

#include <utility>

namespace roomatlas::io {
namespace {

constexpr std::size_t kBeginning_bytes = 16;

bool begins_recording(std::string_view beginning) {
  return is_ros1_bag(beginning) || beginning.starts_with(kMcapMagic) ||
         beginning.starts_with(kSqliteMagic);
}

/// `file` may be a temporary one: it can be removed as soon as it is open.
std::unique_ptr<BagReader> open_unpacked(const std::filesystem::path& file,
                                         const std::string& shown_name) {
  auto bag_file = std::make_unique<BagFile>(file, shown_name);
  const std::string beginning(as_text(bag_file->view(0, kBeginning_bytes)));
  if (is_ros1_bag(beginning)) return open_ros1_bag(std::move(bag_file));
  if (beginning.starts_with(kMcapMagic)) {
    return with_messages_unpacked(open_mcap(std::move(bag_file)));
  }
  auto bag = open_sqlite_bag(file, shown_name);
  return bag ? with_messages_unpacked(std::move(bag)) : nullptr;
}

std::unique_ptr<BagReader> open_packed(BagFile& packed) {
  TemporaryFile unpacked;
  std::string fault;
  if (!unpack_file(packed, unpacked, begins_recording, fault)) return nullptr;
  auto bag = open_unpacked(unpacked.path(), packed.name());
  if (!bag) return nullptr;
  std::string format = bag->format();
  if (format.ends_with(')')) {
    format.insert(format.size() - 1, ", zstd");
  } else {
    format += " (zstd)";
  }
  Issues issues;
  if (!fault.empty()) issues.push_back({Severity::warning, packed.name(), 0, "", fault});
  return with_remarks(std::move(bag), std::move(format), std::move(issues));
}

std::unique_ptr<BagReader> open_bag_file(const std::filesystem::path& file) {
  BagFile bag_file(file, file.string());
  const std::string beginning(as_text(bag_file.view(0, kBeginning_bytes)));
  if (begins_recording(beginning)) return open_unpacked(file, file.string());
  const ByteSpan first = std::as_bytes(std::span(beginning));
  return is_zstd(first) ? open_packed(bag_file) : nullptr;
}

}  // namespace

bool is_bag_by_magic(const std::filesystem::path& file) {
  BagFile bag_file(file, file.string());
  const std::string beginning(as_text(bag_file.view(0, kBeginning_bytes)));
  return is_ros1_bag(beginning) || beginning.starts_with(kMcapMagic);
}

std::unique_ptr<BagReader> open_bag(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return open_rosbag2_folder(path, open_bag_file);
  return open_bag_file(path);
}

}  // namespace roomatlas::io
