// SPDX-License-Identifier: GPL-3.0-or-later
#include "console.hpp"
#include "printable.hpp"
#include "progress_text.hpp"
#include "roomatlas/core/counted.hpp"

#include <fmt/format.h>
#include <malloc.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cctype>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <map>
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

/// The message, a line, without anything that a terminal obeys.
class PrintablePayload : public spdlog::custom_flag_formatter {
 public:
  void format(const spdlog::details::log_msg& message, const std::tm&,
              spdlog::memory_buf_t& to) override {
    const std::string text = printable({message.payload.data(), message.payload.size()});
    to.append(text.data(), text.data() + text.size());
  }
  [[nodiscard]] std::unique_ptr<custom_flag_formatter> clone() const override {
    return std::make_unique<PrintablePayload>();
  }
};

}  // namespace

void set_up_console(const Settings& settings) {
  // Quiet is quiet for every command: who asks for --json as well wants that and nothing else.
  if (settings.quiet && !settings.json && std::freopen("/dev/null", "w", stdout) == nullptr) {
    throw std::runtime_error("/dev/null cannot be opened");
  }
  auto logger = spdlog::stderr_color_st("roomatlas");
  auto formatter = std::make_unique<spdlog::pattern_formatter>();
  formatter->add_flag<PrintablePayload>('*').set_pattern("%^%l%$: %*");
  logger->set_formatter(std::move(formatter));
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
      if (!is_terminal_) std::fprintf(stderr, "%s ...\n", printable(stage).c_str());
    }
    const std::string text = printable(progress_text(stage, done, seconds(now - began_)));
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

namespace {

/// What issues of one kind have in common: all but numbers and what stands in quotes.
std::string wording_of(const Issue& issue) {
  std::string kind = issue.field + ": ";
  bool is_quoted = false;
  for (const char c : issue.message) {
    if (c == '\'' || c == '"') is_quoted = !is_quoted;
    const bool is_number = std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-';
    if (!is_quoted && !is_number) kind += c;
  }
  return kind;
}

/// Shows the first of a kind, and counts the others.
class Shown {
 public:
  void take(const Issue& issue) {
    if (++kinds_[wording_of(issue)] > kMostOfAKind || shown_ >= kMostInAll) {
      ++hidden_;
      return;
    }
    ++shown_;
    spdlog::log(issue.severity == Severity::error ? spdlog::level::err : spdlog::level::warn, "{}",
                to_string(issue));
  }
  [[nodiscard]] std::int64_t hidden() const { return hidden_; }

 private:
  static constexpr int kMostOfAKind = 3;
  static constexpr int kMostInAll = 30;
  std::map<std::string, int> kinds_;
  int shown_ = 0;
  std::int64_t hidden_ = 0;
};

}  // namespace

void show(const std::vector<SeenLast>& seen_last, const std::filesystem::path& store) {
  for (const SeenLast& seen : seen_last) spdlog::info("{}: {}", store.string(), words(seen));
}

void show(const Issues& issues, std::int64_t not_listed) {
  std::size_t notes = 0;
  Shown shown;
  for (const Issue& issue : issues) {
    if (issue.severity == Severity::note) {
      spdlog::debug("{}", to_string(issue));
      ++notes;
    } else {
      shown.take(issue);
    }
  }
  if (const std::int64_t more = shown.hidden() + not_listed; more > 0) {
    spdlog::warn("{} more like these", more);
  }
  if (notes > 0)
    spdlog::info("{} (-v shows {})", counted(notes, "note"), notes == 1 ? "it" : "them");
}

}  // namespace roomatlas::apps
