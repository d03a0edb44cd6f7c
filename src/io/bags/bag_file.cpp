// SPDX-License-Identifier: GPL-3.0-or-later
#include "bag_file.hpp"

#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/files/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace roomatlas::io {
namespace {

constexpr std::size_t kReadAhead_bytes = std::size_t{1} << 18;  // places that follow each other
constexpr std::size_t kGlance_bytes = std::size_t{1} << 12;     // places far apart: one page
constexpr std::uint64_t kFar_bytes = std::uint64_t{1} << 15;

}  // namespace

BagFile::BagFile(const std::filesystem::path& file, std::string shown_name)
    : name_(std::move(shown_name)) {
  require_regular_file(file);
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    throw InputError(name_ + ": is a directory; name a file inside it");
  }
  descriptor_ = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0) {
    if (errno == ENOENT) throw InputError(name_ + ": there is no such file; check the path");
    throw InputError(name_ + ": cannot be opened: " + std::strerror(errno));
  }
  struct stat status = {};
  if (::fstat(descriptor_, &status) == 0) size_ = static_cast<std::uint64_t>(status.st_size);
}

BagFile::~BagFile() { ::close(descriptor_); }

std::size_t BagFile::read(std::uint64_t offset, std::span<std::byte> into) const {
  std::size_t got = 0;
  while (got < into.size() && offset + got < size_) {
    const ::ssize_t count = ::pread(descriptor_, into.data() + got, into.size() - got,
                                    static_cast<::off_t>(offset + got));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      throw InputError(name_ + ": cannot be read at byte " + std::to_string(offset + got) + ": " +
                       std::strerror(errno) + "; copy the file to another disk");
    }
    if (count == 0) break;  // shortened meanwhile
    got += static_cast<std::size_t>(count);
  }
  return got;
}

ByteSpan BagFile::view(std::uint64_t offset, std::size_t bytes) {
  if (offset >= size_) return {};
  bytes = static_cast<std::size_t>(std::min<std::uint64_t>(bytes, size_ - offset));
  const std::uint64_t window_end = window_offset_ + window_.size();
  if (offset < window_offset_ || offset + bytes > window_end) {
    const bool is_far = offset < window_offset_ || offset > window_end + kFar_bytes;
    window_.resize(std::max(bytes, is_far ? kGlance_bytes : kReadAhead_bytes));
    window_offset_ = offset;
    window_.resize(read(offset, window_.span()));
  }
  const ByteSpan window = window_.view().subspan(static_cast<std::size_t>(offset - window_offset_));
  return window.first(std::min(bytes, window.size()));
}

}  // namespace roomatlas::io
