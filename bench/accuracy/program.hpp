// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace roomatlas::bench {

/// How a program ended and what it took.
struct Finished {
  int exit_code = -1;  ///< 128 and the signal where one ended it
  double elapsed_s = 0.0;
  double processor_s = 0.0;
  double peak_mb = 0.0;
  std::string complaint;  ///< its last line on stderr
};

/// Runs the built `roomatlas`, or what ROOMATLAS_PROGRAM names, with these arguments and waits for
/// it. What it prints goes to `log`.
[[nodiscard]] Finished run_roomatlas(const std::vector<std::string>& arguments,
                                     const std::filesystem::path& log);

/// The same of another program.
[[nodiscard]] Finished run_program(const std::string& program,
                                   const std::vector<std::string>& arguments,
                                   const std::filesystem::path& log);

}  // namespace roomatlas::bench
