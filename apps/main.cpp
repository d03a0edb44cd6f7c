// SPDX-License-Identifier: GPL-3.0-or-later
#include <glog/logging.h>
#include <malloc.h>

#include "command_line.hpp"
#include "exit_code.hpp"

int main(int argc, char** argv) {
  using namespace roomatlas::apps;
  constexpr int kLargeBytes = 1024 * 1024;
  (void)mallopt(M_MMAP_THRESHOLD, kLargeBytes);  // grids go back to the system once they are freed
  FLAGS_minloglevel = google::GLOG_FATAL;        // Ceres logs even when asked to be silent
  google::InitGoogleLogging(argv[0]);
  return exit_code_of([&] { return run_command_line(argc, argv); });
}
