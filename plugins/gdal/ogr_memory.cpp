// SPDX-License-Identifier: GPL-3.0-or-later
#include "ogr_memory.hpp"

#include <cpl_error.h>
#include <cpl_string.h>
#include <cpl_vsi.h>

#include <stdexcept>

namespace roomatlas::ogr {
namespace {

std::string content_of(const std::string& path) {
  vsi_l_offset size = 0;
  const GByte* bytes = VSIGetMemFileBuffer(path.c_str(), &size, FALSE);
  if (bytes == nullptr) throw std::runtime_error(path + ": " + last_error());
  return {reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size)};
}

}  // namespace

std::string last_error() {
  const std::string message = CPLGetLastErrorMsg();
  return message.empty() ? "unknown reason" : message;
}

MemoryFolder::MemoryFolder(const std::string& name) : folder_("/vsimem/roomatlas-" + name) {
  VSIRmdirRecursive(folder_.c_str());
  VSIMkdir(folder_.c_str(), 0755);
}

MemoryFolder::~MemoryFolder() { VSIRmdirRecursive(folder_.c_str()); }

void MemoryFolder::put(const std::string& name, const std::string& content) const {
  VSILFILE* file = VSIFOpenL(path(name).c_str(), "wb");
  if (file == nullptr) throw std::runtime_error(path(name) + ": " + last_error());
  VSIFWriteL(content.data(), 1, content.size(), file);
  VSIFCloseL(file);
}

std::vector<std::pair<std::string, std::string>> MemoryFolder::files() const {
  std::vector<std::pair<std::string, std::string>> found;
  const CPLStringList names(VSIReadDirRecursive(folder_.c_str()));
  for (int i = 0; i < names.Count(); ++i) {
    const std::string name = names[i];
    VSIStatBufL status;
    if (VSIStatL(path(name).c_str(), &status) != 0 || VSI_ISDIR(status.st_mode)) continue;
    found.emplace_back(name, content_of(path(name)));
  }
  return found;
}

}  // namespace roomatlas::ogr
