// SPDX-License-Identifier: GPL-3.0-or-later
#include "console.hpp"
#include "roomatlas/core/counted.hpp"

#include <fmt/format.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <memory>
#include <stdexcept>

namespace roomatlas::apps {
namespace {

volatile std::sig_atomic_t stop_requested = 0;  // a signal handler can reach nothing else

extern "C" void request_stop(int) {
  (void)std::signal(SIGINT, SIG_DFL);  // a second one ends the process at once
  (void)std::signal(SIGTERM, SIG_DFL);
  stop_requested = 1;
}

/// While it lives, Ctrl-C and SIGTERM ask to stop; before and after, they do what they did.
class SignalWatch {
 public:
  SignalWatch() {
    struct sigaction watched = {};
    watched.sa_handler = request_stop;
    watched.sa_flags = SA_RESTART;
    sigemptyset(&watched.sa_mask);
    for (const int both : {SIGINT, SIGTERM}) sigaddset(&watched.sa_mask, both);
    sigaction(SIGINT, &watched, &interrupt_before_);
    sigaction(SIGTERM, &watched, &terminate_before_);
  }
  ~SignalWatch() {
    sigaction(SIGINT, &interrupt_before_, nullptr);
    sigaction(SIGTERM, &terminate_before_, nullptr);
  }
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

 private:
  struct sigaction interrupt_before_ = {};
  struct sigaction terminate_before_ = {};
};

}  // namespace

void set_up_console(const Settings& settings) {
  // Quiet is quiet for every command: who asks for --json as well wants that and nothing else.
  if (settings.quiet && !settings.json && std::freopen("/dev/null", "w", stdout) == nullptr) {
    throw std::runtime_error("/dev/null cannot be opened");
  }
  auto logger = spdlog::stderr_color_st("roomatlas");
  logger->set_pattern("%^%l%$: %v");
  logger->set_level(settings.quiet     ? spdlog::level::err
                    : settings.verbose ? spdlog::level::debug
                                       : spdlog::level::info);
  spdlog::set_default_logger(logger);
}

Progress console_progress(const Settings& settings) {
  const bool terminal = isatty(STDERR_FILENO) != 0;
  return [=, watch = std::make_shared<SignalWatch>(), last = std::string()](
             const std::string& stage, double done) mutable {
    if (settings.quiet) return stop_requested == 0;
    if (terminal) {
      const int percent = static_cast<int>(100.0 * std::clamp(done, 0.0, 1.0));
      std::fprintf(stderr, "\r\033[K%s %d %%\r", stage.c_str(), percent);
    } else if (stage != last) {
      std::fprintf(stderr, "%s ...\n", stage.c_str());
    }
    last = stage;
    return stop_requested == 0;
  };
}

std::string describe(const OdometryHabits& habits) {
  return fmt::format("{:+.2f} deg a metre, turns x {:.3f}, lengths x {:.3f}",
                     degrees(habits.bias_rad_per_m), habits.turn_gain, habits.length_scale);
}

void show(const Issues& issues, std::int64_t not_listed, std::size_t limit) {
  std::size_t notes = 0;
  std::size_t shown = 0;
  for (const Issue& issue : issues) {
    if (issue.severity == Severity::note) {
      spdlog::debug("{}", to_string(issue));
      ++notes;
    } else if (shown < limit) {
      spdlog::log(issue.severity == Severity::error ? spdlog::level::err : spdlog::level::warn,
                  "{}", to_string(issue));
      ++shown;
    }
  }
  const auto more = std::ssize(issues) - static_cast<std::ptrdiff_t>(notes + shown) + not_listed;
  if (more > 0) spdlog::warn("{} more of these", more);
  if (notes > 0)
    spdlog::info("{} (-v shows {})", counted(notes, "note"), notes == 1 ? "it" : "them");
}

}  // namespace roomatlas::apps
