// SPDX-License-Identifier: GPL-3.0-or-later
#include "program.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>

namespace roomatlas::bench {
namespace {

/// Takes the place of this process; only ever called in a child.
[[noreturn]] void become(const std::string& program, const std::vector<std::string>& arguments,
                         const std::filesystem::path& log) {
  std::vector<char*> words = {const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments)
    words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file >= 0) {
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
  }
  execv(words.front(), words.data());
  _exit(127);
}

std::string last_line_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string last;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

Finished run_roomatlas(const std::vector<std::string>& arguments,
                       const std::filesystem::path& log) {
  const char* other = std::getenv("ROOMATLAS_PROGRAM");
  return run_program(other != nullptr ? other : ROOMATLAS_PROGRAM, arguments, log);
}

Finished run_program(const std::string& program, const std::vector<std::string>& arguments,
                     const std::filesystem::path& log) {
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child == 0) become(program, arguments, log);
  int status = 0;
  rusage usage{};
  if (child < 0 || wait4(child, &status, 0, &usage) != child) return {};
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  Finished finished;
  finished.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  finished.elapsed_s = elapsed.count();
  finished.processor_s = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
  finished.peak_mb = static_cast<double>(usage.ru_maxrss) / 1024.0;
  if (finished.exit_code != 0) finished.complaint = last_line_of(log);
  return finished;
}

}  // namespace roomatlas::bench
