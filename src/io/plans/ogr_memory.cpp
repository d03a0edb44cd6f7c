// SPDX-License-Identifier: GPL-3.0-or-later
#ifdef ROOMATLAS_GDAL

#include "ogr_memory.hpp"

#include <cpl_error.h>
#include <cpl_string.h>
#include <cpl_vsi.h>

#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/files/files.hpp"

namespace roomatlas::ogr {
namespace {

std::string content_of(const std::string& path) {
  vsi_l_offset size = 0;
  const GByte* bytes = VSIGetMemFileBuffer(path.c_str(), &size, FALSE);
  if (bytes == nullptr) throw InputError(path + ": " + last_error());
  return {reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size)};
}

}  // namespace

std::string last_error() {
  const std::string message = CPLGetLastErrorMsg();
  return message.empty() ? "unknown reason" : message;
}

GDALDriver* driver_of(const std::string& name) {
  GDALAllRegister();
  CPLSetErrorHandler(CPLQuietErrorHandler);  // what goes wrong is thrown, not printed
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(name.c_str());
  const bool can_write = driver != nullptr &&
                         driver->GetMetadataItem(GDAL_DCAP_VECTOR) != nullptr &&
                         driver->GetMetadataItem(GDAL_DCAP_CREATE) != nullptr;
  if (!can_write) {
    throw UsageError("GDAL has no vector format \"" + name +
                     "\" that it can write: `ogrinfo --formats` lists them");
  }
  return driver;
}

Dataset create(GDALDriver& driver, const std::string& path,
               const std::vector<std::string>& options) {
  CPLStringList list;
  for (const std::string& option : options) list.AddString(option.c_str());
  Dataset dataset(driver.Create(path.c_str(), 0, 0, 0, GDT_Unknown, list.List()));
  if (dataset == nullptr) throw InputError(last_error());
  return dataset;
}

MemoryFolder::MemoryFolder(const std::string& name) : folder_("/vsimem/roomatlas-" + name) {
  VSIRmdirRecursive(folder_.c_str());
  VSIMkdir(folder_.c_str(), 0755);
}

MemoryFolder::~MemoryFolder() { VSIRmdirRecursive(folder_.c_str()); }

void MemoryFolder::put(const std::string& name, const std::string& content) const {
  VSILFILE* file = VSIFOpenL(path(name).c_str(), "wb");
  if (file == nullptr) throw InputError(path(name) + ": " + last_error());
  VSIFWriteL(content.data(), 1, content.size(), file);
  VSIFCloseL(file);
}

std::vector<std::string> MemoryFolder::write_to(const std::filesystem::path& out) const {
  std::vector<std::string> written;
  const CPLStringList names(VSIReadDirRecursive(folder_.c_str()));
  for (int i = 0; i < names.Count(); ++i) {
    const std::string name = names[i];
    VSIStatBufL status;
    if (VSIStatL(path(name).c_str(), &status) != 0 || VSI_ISDIR(status.st_mode)) continue;
    const std::filesystem::path file = out / name;
    std::filesystem::create_directories(file.parent_path());
    write_file(file, content_of(path(name)));
    written.push_back(name);
  }
  return written;
}

}  // namespace roomatlas::ogr

#endif
