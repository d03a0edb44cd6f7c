// SPDX-License-Identifier: GPL-3.0-or-later
#include "rosbag2_folder.hpp"

#include "files/place_inside.hpp"
#include "rosbag2_metadata.hpp"
#include "wrapped_readers.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

namespace roomatlas::io {
namespace {

namespace fs = std::filesystem;

/// "trace" and 12 of "trace_12.db3".
struct PartName {
  std::string stem;
  std::string number;
};

std::optional<PartName> part_name(std::string name) {
  if (name.ends_with(".zstd")) name.resize(name.size() - 5);
  bool is_part = false;
  for (const std::string_view ending : {".db3", ".mcap"}) {
    if (!name.ends_with(ending)) continue;
    name.resize(name.size() - ending.size());
    is_part = true;
    break;
  }
  if (!is_part) return std::nullopt;
  std::size_t digits = name.size();
  while (digits > 0 && std::isdigit(static_cast<unsigned char>(name[digits - 1])) != 0) --digits;
  std::string number = name.substr(digits);
  number.erase(0, std::min(number.find_first_not_of('0'), number.size()));
  return PartName{name.substr(0, digits), number};
}

/// The recordings in a folder without metadata, in the order of their numbers.
std::vector<fs::path> parts_by_name(const fs::path& folder) {
  std::vector<std::pair<PartName, fs::path>> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    std::error_code unreadable;
    if (!entry.is_regular_file(unreadable)) continue;
    const std::string name = entry.path().filename().string();
    if (auto part = part_name(name)) found.emplace_back(std::move(*part), entry.path());
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    const auto key = [](const auto& part) {
      return std::tuple(part.first.stem, part.first.number.size(), part.first.number, part.second);
    };
    return key(a) < key(b);
  });
  std::vector<fs::path> files;
  for (const auto& [part, file] : found) {
    if (part.stem != found.front().first.stem) {
      throw InputError(folder.string() + ": holds several recordings (" +
                       found.front().second.filename().string() + ", " + file.filename().string() +
                       "), and no metadata.yaml that says which belong together: name one file");
    }
    // Unpacked beside its packed self, as `unzstd` leaves it.
    const bool is_twice = !files.empty() && file.string() == files.back().string() + ".zstd";
    if (!is_twice) files.push_back(file);
  }
  return files;
}

/// Older recorders put the folder's name before the files' names; people rename the folder, and
/// unpack the files.
fs::path place_of(const fs::path& folder, const std::string& listed) {
  const fs::path file(listed);
  std::string unpacked = file.filename().string();
  if (unpacked.ends_with(".zstd")) unpacked.resize(unpacked.size() - 5);
  for (const fs::path& place :
       {place_inside(folder, listed), folder / file.filename(), folder / unpacked}) {
    std::error_code error;
    if (fs::is_regular_file(place, error)) return place;
  }
  return folder / file.filename();
}

Issue warning(const fs::path& folder, std::string message) {
  return {Severity::warning, folder.string(), 0, "", std::move(message)};
}

/// Files that are there but not listed may be another recording's: they are named, not read.
void name_unlisted(const fs::path& folder, const std::vector<fs::path>& files, Issues& issues) {
  std::error_code error;
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    const bool is_listed = std::any_of(files.begin(), files.end(), [&](const fs::path& file) {
      const std::string listed = file.filename().string();
      return name == listed || name == listed + ".zstd" || name + ".zstd" == listed;
    });
    if (part_name(name) && !is_listed) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) {
    issues.push_back(warning(folder, name + " is not listed in metadata.yaml: it was left out"));
  }
}

std::vector<fs::path> listed_parts(const fs::path& folder, const Rosbag2Metadata& metadata,
                                   Issues& issues) {
  std::vector<fs::path> files;
  for (const std::string& listed : metadata.files) {
    const fs::path file = place_of(folder, listed);
    std::error_code error;
    if (fs::is_regular_file(file, error)) {
      files.push_back(file);
    } else {
      issues.push_back(
          warning(folder, listed + " is listed in metadata.yaml and is missing: what it holds was "
                                   "left out"));
    }
  }
  if (!files.empty()) name_unlisted(folder, files, issues);
  return files;
}

}  // namespace

std::unique_ptr<BagReader> open_rosbag2_folder(
    const fs::path& folder,
    const std::function<std::unique_ptr<BagReader>(const fs::path&)>& open) {
  const auto metadata = read_rosbag2_metadata(folder);
  const std::string packed_by = metadata ? metadata->compression_format : "";
  if (!packed_by.empty() && packed_by != "zstd") {
    throw InputError(folder.string() + ": is packed by \"" + packed_by +
                     "\", which is not known here; expected zstd or none: pack it anew with `ros2 "
                     "bag convert`");
  }
  Issues issues;
  std::vector<fs::path> files;
  if (metadata) files = listed_parts(folder, *metadata, issues);
  if (files.empty()) files = parts_by_name(folder);
  if (files.empty()) {
    if (!metadata) return nullptr;
    throw InputError(folder.string() +
                     ": is the folder of a rosbag2 without its recordings; expected the files that "
                     "its metadata.yaml names: copy them there");
  }
  if (!metadata) {
    issues.push_back({Severity::note, folder.string(), 0, "",
                      "there is no metadata.yaml: its files are taken in the order of their "
                      "numbers"});
  }
  std::vector<BagPart> parts;
  bool is_any_packed = false;
  for (const fs::path& file : files) {
    std::error_code error;
    const std::uintmax_t bytes = fs::file_size(file, error);
    parts.push_back({file, error ? 0 : bytes});
    is_any_packed = is_any_packed || file.extension() == ".zstd";
  }
  std::vector<BagTopic> known;
  if (metadata) known = metadata->topics;
  // To look into packed files they would have to be unpacked once more.
  auto bag = in_sequence(folder.string(), std::move(parts), std::move(known), !is_any_packed, open);
  std::string format = "rosbag2 folder: " + bag->format();
  return with_remarks(std::move(bag), std::move(format), std::move(issues));
}

}  // namespace roomatlas::io
