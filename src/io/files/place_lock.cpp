// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/files/place_lock.hpp"

#include "locked_file.hpp"
#include "roomatlas/core/issue.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <utility>

namespace roomatlas {
namespace {

Path lock_file_of(const Path& place) {
  std::error_code missing;
  if (std::filesystem::is_directory(place, missing)) return place / ".roomatlas.lock";
  return place.string() + ".lock";
}

/// " (process 1234)", where the run that holds the lock has written so.
std::string holder(int descriptor) {
  std::array<char, 20> text{};
  const ::ssize_t size = ::pread(descriptor, text.data(), text.size(), 0);
  const std::string number(text.data(), static_cast<std::size_t>(std::max<::ssize_t>(size, 0)));
  const bool is_number =
      !number.empty() && number.find_first_not_of("0123456789") == std::string::npos;
  return is_number ? " (process " + number + ")" : "";
}

}  // namespace

PlaceLock::PlaceLock(const Path& place) : file_(lock_file_of(behind_links(place))) {
  const io::LockedFile opened = io::open_locked(file_);
  if (opened.descriptor < 0) {
    throw InputError(place.string() + ": cannot be locked for writing: " + file_.string() + ": " +
                     std::strerror(opened.error) + "; check the folder and its permissions");
  }
  if (opened.is_taken) {
    const std::string other = holder(opened.descriptor);
    ::close(opened.descriptor);
    throw InputError(place.string() + ": another run" + other +
                     " is writing here, and nothing was touched: wait until it has ended, or give "
                     "another place with -o");
  }
  descriptor_ = opened.descriptor;
  const std::string number = std::to_string(::getpid());
  // Without the number the lock holds as well.
  if (::ftruncate(descriptor_, 0) == 0)
    (void)!::pwrite(descriptor_, number.data(), number.size(), 0);
}

PlaceLock::PlaceLock(PlaceLock&& other) noexcept
    : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

PlaceLock::~PlaceLock() {
  if (descriptor_ < 0) return;
  ::unlink(file_.c_str());  // first, while the lock is held
  ::close(descriptor_);
}

}  // namespace roomatlas
