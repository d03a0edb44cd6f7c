// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <glog/logging.h>
#include <malloc.h>
#include <unistd.h>

#include <csignal>

#include "command_line.hpp"
#include "exit_code.hpp"

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

int main(int argc, char** argv) {
  using namespace roomatlas::apps;
  keep_standard_streams();
  (void)std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error of writing
  constexpr int kLargeBytes = 1024 * 1024;
  (void)mallopt(M_MMAP_THRESHOLD, kLargeBytes);  // grids go back to the system once they are freed
  FLAGS_minloglevel = google::GLOG_FATAL;        // Ceres logs even when asked to be silent
  google::InitGoogleLogging(argv[0]);
  return exit_code_of([&] { return run_command_line(argc, argv); });
}
