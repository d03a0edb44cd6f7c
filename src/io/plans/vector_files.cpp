// SPDX-License-Identifier: GPL-3.0-or-later
#include "plans/vector_files.hpp"

#include <filesystem>

#include "plugins/plugin.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/plans/ogr_export.hpp"

namespace roomatlas {
namespace io {
namespace {

Plugin gdal(const std::string& format) { return {"roomatlas-gdal.so", format, "roomatlas-gdal"}; }

}  // namespace

std::vector<std::string> write_vector_file(const Path& folder, const VectorFile& file) {
  VectorFileBytes bytes;
  function_in<EncodeVectorFile>(gdal("the format " + file.driver), kEncodeVectorFile)(file, bytes);
  if (bytes.is_unknown_format) {
    throw UsageError("GDAL has no vector format \"" + file.driver +
                     "\" that it can write: `ogrinfo --formats` lists them");
  }
  if (!bytes.error.empty()) {
    throw InputError((folder / file.name).string() + ": " + file.driver +
                     " cannot hold the plan: " + bytes.error);
  }
  std::vector<std::string> names;
  for (const auto& [name, content] : bytes.files) {
    std::filesystem::create_directories((folder / name).parent_path());
    write_file(folder / name, content);
    names.push_back(name);
  }
  return names;
}

}  // namespace io

bool has_ogr() { return io::is_there(io::gdal("OGR")); }

}  // namespace roomatlas
