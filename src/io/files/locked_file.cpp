// SPDX-License-Identifier: GPL-3.0-or-later
#include "locked_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace roomatlas::io {
namespace {

/// False where another run has renamed or removed the file after it was opened here: a third run
/// would make a new one, and not see this lock.
bool has_its_name(int descriptor, const std::filesystem::path& file) {
  struct stat opened {};
  struct stat named {};
  return ::fstat(descriptor, &opened) == 0 && ::stat(file.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

}  // namespace

LockedFile open_locked(const std::filesystem::path& file) {
  constexpr int kMode = 0666;  // less what the user's mask takes
  while (true) {
    const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kMode);
    if (descriptor < 0) return {-1, false, errno};
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
      return {descriptor, errno == EWOULDBLOCK, 0};
    }
    if (has_its_name(descriptor, file)) return {descriptor, false, 0};
    ::close(descriptor);
  }
}

}  // namespace roomatlas::io
