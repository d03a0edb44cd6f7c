// SPDX-License-Identifier: GPL-3.0-or-later
// The targets as a test with any compiler: replay_readers NAME [COUNT [SEED]] gives the reader its
// seeds, large inputs, whose numbers are negative, and COUNT mutations of the seeds, some of which
// it lets grow to 1 MiB. Each input has 10 s of
// processor time and 1 GiB of memory; what was used at most is said.
// What fails is told by its number; replay_readers NAME FILE reads it again from a file, and
// replay_readers --list names the targets.
#include <sys/resource.h>
#include <sys/time.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>

#include "mutate.hpp"
#include "roomatlas/core/issue.hpp"
#include "target.hpp"

namespace {

using namespace roomatlas::fuzz;

constexpr long kMost_s = 10;
constexpr std::size_t kMostBytes = std::size_t{1} << 20;
constexpr int kGrown = 200;  // of so many inputs one grows

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;  // which takes terabytes of addresses
#else
constexpr bool kIsSanitized = false;
#endif

volatile std::sig_atomic_t number = 0;  // of the input, for the handler

extern "C" void tell_and_end(int signal) {
  std::fprintf(stderr, "replay_readers: input %d: %s\n", static_cast<int>(number),
               signal == SIGVTALRM ? "more than 10 s" : "ended the program");
  std::_Exit(1);
}

void bound_memory() {
  if (kIsSanitized) return;
  const rlimit limit{rlim_t{1} << 30, rlim_t{1} << 30};
  setrlimit(RLIMIT_DATA, &limit);
}

/// The processor time that it took.
double run_within_time(const Target& target, const std::string& bytes) {
  const std::clock_t begin = std::clock();
  const itimerval time{{0, 0}, {kMost_s, 0}};
  setitimer(ITIMER_VIRTUAL, &time, nullptr);
  run_input(target, bytes);
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// A mutation of a seed, that of this number.
std::string input_of(const std::vector<std::string>& seeds, int index, std::uint64_t seed) {
  Random random(seed * 1'000'003 + static_cast<std::uint64_t>(index));
  const std::string& bytes = seeds[random() % seeds.size()];
  const std::string& other = seeds[random() % seeds.size()];
  if (index % kGrown != 0) return mutated(bytes, other, random, kMostBytes);
  return mutated(grown(bytes, random, kMostBytes), other, random, kMostBytes);
}

double most_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void replay(const Target& target, int count, std::uint64_t seed) {
  const std::vector<std::string> seeds = target.seeds();
  const std::vector<std::string> large = target.large();
  bound_memory();
  double slowest_s = 0.0;
  for (const std::string& bytes : seeds) {
    slowest_s = std::max(slowest_s, run_within_time(target, bytes));
  }
  for (const std::string& bytes : large) {
    number = number - 1;
    slowest_s = std::max(slowest_s, run_within_time(target, bytes));
  }
  for (int i = 1; i <= count; ++i) {
    number = i;
    const std::string input = input_of(seeds, i, seed);
    if (const char* keep = std::getenv("ROOMATLAS_KEEP_INPUT")) {
      std::ofstream(keep, std::ios::binary) << input;
    }
    slowest_s = std::max(slowest_s, run_within_time(target, input));
  }
  std::printf("%s: %zu seeds and %d mutations, at most %.2f s and %.0f MB\n", target.name.c_str(),
              seeds.size(), count, slowest_s, most_memory_mb());
}

}  // namespace

int main(int count, char** arguments) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGVTALRM}) {
    if (!kIsSanitized || signal == SIGVTALRM) (void)std::signal(signal, tell_and_end);
  }
  if (count > 1 && std::string(arguments[1]) == "--list") {
    for (const Target& known : all_targets()) std::printf("%s\n", known.name.c_str());
    return 0;
  }
  try {
    const Target& target = target_named(count > 1 ? arguments[1] : "");
    const std::string what = count > 2 ? arguments[2] : "2000";
    if (std::filesystem::is_regular_file(what)) {
      std::ifstream in(what, std::ios::binary);
      (void)run_within_time(target, std::string(std::istreambuf_iterator<char>(in), {}));
    } else {
      replay(target, std::atoi(what.c_str()),
             count > 3 ? std::strtoull(arguments[3], nullptr, 10) : 1);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "replay_readers: %s\n", error.what());
    return 2;
  }
}
