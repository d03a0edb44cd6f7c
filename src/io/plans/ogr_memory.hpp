// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gdal_priv.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

/// GDAL's side of the exports. Private; included in builds with GDAL alone.
namespace roomatlas::ogr {

struct Close {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, Close>;

/// What went wrong last, as GDAL says it.
[[nodiscard]] std::string last_error();

/// The driver of that name. Throws UsageError where this GDAL has none that writes vectors.
[[nodiscard]] GDALDriver* driver_of(const std::string& name);

/// A new dataset. Throws InputError. @param options KEY=VALUE
[[nodiscard]] Dataset create(GDALDriver& driver, const std::string& path,
                             const std::vector<std::string>& options);

/// A folder in memory, where formats of several files are written before they get their place.
class MemoryFolder {
 public:
  explicit MemoryFolder(const std::string& name);
  ~MemoryFolder();
  MemoryFolder(const MemoryFolder&) = delete;
  MemoryFolder& operator=(const MemoryFolder&) = delete;

  [[nodiscard]] std::string path(const std::string& name) const { return folder_ + "/" + name; }
  void put(const std::string& name, const std::string& content) const;
  /// Writes all files below the folder on disk; each appears when it is whole. Returns their names.
  std::vector<std::string> write_to(const std::filesystem::path& out) const;

 private:
  std::string folder_;
};

}  // namespace roomatlas::ogr
