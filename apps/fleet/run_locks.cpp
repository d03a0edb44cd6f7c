// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_locks.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "roomatlas/core/issue.hpp"

namespace roomatlas::apps {
namespace {

struct flock one_byte(short type, off_t byte) {
  struct flock lock = {};
  lock.l_type = type;
  lock.l_whence = SEEK_SET;
  lock.l_start = byte;
  lock.l_len = 1;
  return lock;
}

}  // namespace

RunLocks::RunLocks(const Path& file)
    : file_(file), descriptor_(open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
  if (descriptor_ >= 0) return;
  throw InputError(file.string() + ": cannot be opened: " + std::strerror(errno));
}

RunLocks::~RunLocks() { close(descriptor_); }

bool RunLocks::take(off_t byte) const {
  struct flock lock = one_byte(F_WRLCK, byte);
  if (fcntl(descriptor_, F_SETLK, &lock) == 0) return true;
  if (errno == EACCES || errno == EAGAIN) return false;
  throw InputError(
      file_.string() + ": cannot be locked: " + std::strerror(errno) +
      "; the output must lie on a file system with locks for all nodes, such as NFS 4");
}

void RunLocks::give_back(off_t byte) const {
  struct flock lock = one_byte(F_UNLCK, byte);
  (void)fcntl(descriptor_, F_SETLK, &lock);
}

bool RunLocks::is_held(off_t byte) const {
  struct flock lock = one_byte(F_WRLCK, byte);
  return fcntl(descriptor_, F_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
}

}  // namespace roomatlas::apps
