// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the real program beside the test, which can send it signals.
#pragma once

#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "program.hpp"

namespace roomatlas::test {

class Child {
 public:
  /// @param shell what the shell is told before it becomes the program
  /// @param program another than the one of this project
  explicit Child(const std::string& arguments, const std::string& shell = "",
                 const std::string& program = ROOMATLAS_PROGRAM) {
    const std::string command = shell + "exec " + program + " " + arguments + " >" +
                                (folder_ / "out").string() + " 2>" + (folder_ / "err").string();
    pid_ = fork();
    if (pid_ != 0) return;
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  ~Child() {
    if (pid_ <= 0) return;
    kill(pid_, SIGKILL);
    (void)wait();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  [[nodiscard]] std::string err() const { return content_of(folder_ / "err"); }
  /// Waits until stderr holds the text; false when the program ended before.
  [[nodiscard]] bool has_said(const std::string& text) {
    while (err().find(text) == std::string::npos) {
      if (has_ended()) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
  }
  [[nodiscard]] bool has_ended() {
    if (pid_ > 0 && waitpid(pid_, &status_, WNOHANG) == pid_) pid_ = 0;
    return pid_ == 0;
  }
  /// Sends all of them before the program goes on, if it has not ended.
  void send(std::initializer_list<int> signals) {
    if (has_ended()) return;
    kill(pid_, SIGSTOP);
    int status = 0;
    waitpid(pid_, &status, WUNTRACED);
    for (const int signal : signals) kill(pid_, signal);
    kill(pid_, SIGCONT);
  }
  /// Holds the program until `resume`.
  void pause() {
    if (has_ended()) return;
    kill(pid_, SIGSTOP);
    int status = 0;
    waitpid(pid_, &status, WUNTRACED);
  }
  void resume() const { kill(pid_, SIGCONT); }
  [[nodiscard]] pid_t pid() const { return pid_; }
  /// Waits for its end. @returns the signal that ended it, 0 where none did
  int wait() {
    if (pid_ > 0) waitpid(pid_, &status_, 0);
    pid_ = 0;
    return WIFSIGNALED(status_) ? WTERMSIG(status_) : 0;
  }
  [[nodiscard]] int exit_code() const { return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1; }

 private:
  Folder folder_;
  pid_t pid_ = -1;
  int status_ = 0;
};

}  // namespace roomatlas::test
