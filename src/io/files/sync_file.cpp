// SPDX-License-Identifier: GPL-3.0-or-later
#include "sync_file.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace roomatlas {

void sync_to_disk(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace roomatlas
