// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace roomatlas::ogr {

/// What went wrong last, as GDAL says it.
[[nodiscard]] std::string last_error();

/// A folder in memory, where files are written before they get their place.
class MemoryFolder {
 public:
  explicit MemoryFolder(const std::string& name);
  ~MemoryFolder();
  MemoryFolder(const MemoryFolder&) = delete;
  MemoryFolder& operator=(const MemoryFolder&) = delete;

  [[nodiscard]] std::string path(const std::string& name) const { return folder_ + "/" + name; }
  void put(const std::string& name, const std::string& content) const;
  /// All files below the folder: names there, and contents.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> files() const;

 private:
  std::string folder_;
};

}  // namespace roomatlas::ogr
