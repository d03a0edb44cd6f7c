// SPDX-License-Identifier: GPL-3.0-or-later
#include "console.hpp"
#include "progress_text.hpp"
#include "roomatlas/core/counted.hpp"

#include <fmt/format.h>
#include <malloc.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <chrono>
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

namespace {

/// Shows how far a stage is.
class ProgressLine {
 public:
  void show(const std::string& stage, double done) {
    const auto now = Clock::now();
    if (stage != stage_) {
      stage_ = stage;
      began_ = now;
      told_ = now;
      if (!is_terminal_) std::fprintf(stderr, "%s ...\n", stage.c_str());
    }
    const std::string text = progress_text(stage, done, seconds(now - began_));
    if (is_terminal_) {
      std::fprintf(stderr, "\r\033[K%s\r", text.c_str());
    } else if (seconds(now - told_) >= kBetweenLines_s) {
      std::fprintf(stderr, "%s\n", text.c_str());
      told_ = now;
    }
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr double kBetweenLines_s = 10.0;  // where lines stay, few of them

  static double seconds(Clock::duration time) {
    return std::chrono::duration<double>(time).count();
  }

  bool is_terminal_ = isatty(STDERR_FILENO) != 0;
  std::string stage_;
  Clock::time_point began_;
  Clock::time_point told_;
};

/// Gives back what the stages before have freed: pieces between what is still held, which the
/// C library keeps (of a large building a fifth of all).
class FreedMemory {
 public:
  void give_back_before(const std::string& stage) {
    if (stage == stage_) return;
    stage_ = stage;
#ifdef __GLIBC__
    malloc_trim(0);
#endif
  }

 private:
  std::string stage_;
};

}  // namespace

Progress console_progress(const Settings& settings) {
  return [quiet = settings.quiet, watch = std::make_shared<SignalWatch>(),
          line = std::make_shared<ProgressLine>(),
          freed = std::make_shared<FreedMemory>()](const std::string& stage, double done) {
    freed->give_back_before(stage);
    if (!quiet) line->show(stage, done);
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
