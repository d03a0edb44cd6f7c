// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.hpp"
#include "exit_code.hpp"
#include "set_up_process.hpp"

int main(int argc, char** argv) {
  using namespace roomatlas::apps;
  set_up_process(argv[0]);
  return exit_code_of([&] { return run_command_line(argc, argv); });
}
