// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace roomatlas::apps {

enum ExitCode {
  kOk = 0,
  kInternal = 1,
  kUsage = 2,
  kInput = 3,
  kNotEnough = 4,
  kGateFailed = 5,
  kInterrupted = 130,
};

/// Reads the command line and runs what it asks for. Throws what the command throws.
/// @returns the exit code of a command line that is answered at once: help, version, wrong usage
int run_command_line(int argc, char** argv);

}  // namespace roomatlas::apps
