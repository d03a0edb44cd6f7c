// SPDX-License-Identifier: GPL-3.0-or-later
#include "set_up_process.hpp"

#include <fcntl.h>
#include <glog/logging.h>
#include <malloc.h>
#include <unistd.h>

#include <csignal>

namespace roomatlas::apps {
namespace {

/// Where a caller has closed standard input, output or error, the next file that is opened would
/// take its number, and get what is printed.
void keep_standard_streams() {
  while (true) {
    const int file = open("/dev/null", O_RDWR | O_CLOEXEC);
    if (file > STDERR_FILENO) {
      (void)close(file);
      return;
    }
    if (file < 0) return;
  }
}

}  // namespace

void set_up_process(const char* program) {
  keep_standard_streams();
  (void)std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error of writing
  constexpr int kLargeBytes = 1024 * 1024;
  (void)mallopt(M_MMAP_THRESHOLD, kLargeBytes);  // grids go back to the system once they are freed,
  (void)mallopt(M_TRIM_THRESHOLD, 64 * kLargeBytes);  // and what is small does not with each room
  (void)mallopt(M_TOP_PAD, 4 * kLargeBytes);
  FLAGS_minloglevel = google::GLOG_FATAL;  // Ceres logs even when asked to be silent
  google::InitGoogleLogging(program);
}

}  // namespace roomatlas::apps
