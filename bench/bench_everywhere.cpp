// SPDX-License-Identifier: GPL-3.0-or-later
// Buildings, sensors and odometry that nobody tuned on: each case is drawn by seed, simulated,
// built by the program itself and judged by where the robot truly was. A table in Markdown on
// stdout, each case on stderr as soon as it is known, all figures in
// out/everywhere/SEED/cases.jsonl.
//
//   bench_everywhere [--seed S] [--from N] [--count N] [--stratum NAME] [--jobs N]
//                    [--max-minutes M] [--keep]
//     --seed         of the run; without it the day's date, so that tomorrow has other cases
//     --from         first case (0)
//     --count        of cases (300)
//     --stratum      laser, sonar, hard or recorded: its cases alone
//     --jobs         cases at once, each in a process of its own (2)
//     --max-minutes  no case begins later (480)
//     --keep         missions and maps stay in out/everywhere/SEED/CASE
//
// ROOMATLAS_PROGRAM names another build of the program to be judged.
//
// Cases that cases.jsonl has already are not run again.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "everywhere/case_run.hpp"
#include "everywhere/everywhere_table.hpp"
#include "recorded_data.hpp"

namespace {

using namespace roomatlas::bench;
namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr rlim_t kMostProcessor_s = 1800;  // of one program; who needs more has failed

struct Wanted {
  std::uint64_t seed = 0;
  std::uint64_t from = 0;
  std::uint64_t count = 300;
  std::optional<Stratum> stratum;
  std::size_t jobs = 2;
  double max_minutes = 480.0;
  bool keep = false;
};

std::uint64_t today() {
  const std::time_t now = std::time(nullptr);
  std::tm date{};
  gmtime_r(&now, &date);
  return static_cast<std::uint64_t>((date.tm_year + 1900) * 10000 + (date.tm_mon + 1) * 100 +
                                    date.tm_mday);
}

[[noreturn]] void refuse(const std::string& why) {
  std::fprintf(stderr, "bench_everywhere: %s; bench/bench_everywhere.cpp says what it takes\n",
               why.c_str());
  std::exit(2);
}

Stratum stratum_named(const std::string& name) {
  if (name == "laser") return Stratum::laser;
  if (name == "sonar") return Stratum::sonar;
  if (name == "hard") return Stratum::hard;
  if (name == "recorded") return Stratum::recorded;
  refuse("no stratum '" + name + "'");
}

Wanted wanted_of(const std::vector<std::string>& words) {
  Wanted wanted;
  wanted.seed = today();
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--keep") {
      wanted.keep = true;
      continue;
    }
    if (i + 1 == words.size()) refuse("unknown, or without its value: " + words[i]);
    const std::string& value = words[i + 1];
    if (words[i] == "--stratum") {
      wanted.stratum = stratum_named(value);
      ++i;
      continue;
    }
    char* end = nullptr;
    const std::uint64_t number = std::strtoull(value.c_str(), &end, 10);
    if (value.empty() || *end != '\0') refuse(words[i] + ": not a number: " + value);
    if (words[i] == "--seed") {
      wanted.seed = number;
    } else if (words[i] == "--from") {
      wanted.from = number;
    } else if (words[i] == "--count") {
      wanted.count = number;
    } else if (words[i] == "--jobs" && number > 0) {
      wanted.jobs = number;
    } else if (words[i] == "--max-minutes") {
      wanted.max_minutes = static_cast<double>(number);
    } else {
      refuse("unknown: " + words[i] + " " + value);
    }
    ++i;
  }
  return wanted;
}

/// The cases of the file; a line that a full disk or a killed run cut off is none.
std::vector<Json> cases_in(const fs::path& file) {
  std::vector<Json> cases;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    Json one = Json::parse(line, nullptr, false);
    if (one.is_object() && one.contains("case")) cases.push_back(std::move(one));
  }
  return cases;
}

class Run {
 public:
  Run(const Wanted& wanted, fs::path out)
      : wanted_(wanted), out_(std::move(out)), file_(out_ / "cases.jsonl") {
    fs::create_directories(out_);
    for (const Json& one : cases_in(file_)) done_.insert(one.at("case").get<std::uint64_t>());
  }

  void run_all() {
    const auto start = std::chrono::steady_clock::now();
    for (std::uint64_t i = 0; i < wanted_.count; ++i) {
      const DrawnCase drawn = drawn_case(wanted_.seed, wanted_.from + i, recorded_data());
      if (wanted_.stratum && drawn.stratum != *wanted_.stratum) continue;
      if (done_.contains(drawn.number)) continue;
      const std::chrono::duration<double, std::ratio<60>> taken =
          std::chrono::steady_clock::now() - start;
      if (taken.count() >= wanted_.max_minutes) break;
      if (running_.size() >= wanted_.jobs) wait_for_one();
      begin(drawn);
    }
    while (!running_.empty()) wait_for_one();
  }

  [[nodiscard]] const fs::path& file() const { return file_; }

 private:
  void append(const Json& row) const {
    const std::string line = row.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    std::FILE* file = std::fopen(file_.c_str(), "a");
    if (file == nullptr) return;
    std::setvbuf(file, nullptr, _IOFBF, line.size() + 1);  // one write, whatever runs beside
    std::fputs(line.c_str(), file);
    std::fclose(file);
    std::fprintf(stderr, "%s", everywhere_line(row).c_str());
  }

  void begin(const DrawnCase& drawn) {
    const pid_t child = fork();
    if (child < 0) refuse("no process can be made");
    if (child > 0) {
      running_.emplace(child, drawn);
      return;
    }
    const rlimit limit{kMostProcessor_s, kMostProcessor_s};
    setrlimit(RLIMIT_CPU, &limit);
    const fs::path folder = out_ / std::to_string(drawn.number);
    append(run_case(drawn, folder));
    std::error_code ignored;
    if (!wanted_.keep) fs::remove_all(folder, ignored);
    _exit(0);
  }

  void wait_for_one() {
    int status = 0;
    const pid_t child = wait(&status);
    const auto ended = running_.find(child);
    if (ended == running_.end()) return;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
      Json row = description_of(ended->second);
      row["failure"] = "judging: the process ended with status " + std::to_string(status);
      append(row);
    }
    running_.erase(ended);
  }

  Wanted wanted_;
  fs::path out_;
  fs::path file_;
  std::set<std::uint64_t> done_;
  std::map<pid_t, DrawnCase> running_;
};

}  // namespace

int main(int argc, char** argv) {
  const Wanted wanted = wanted_of({argv + 1, argv + argc});
  const fs::path out =
      fs::path(ROOMATLAS_SOURCE_DIR) / "out" / "everywhere" / std::to_string(wanted.seed);
  Run run(wanted, out);
  run.run_all();
  std::vector<Json> cases = cases_in(run.file());
  std::erase_if(cases, [&](const Json& one) {
    const auto number = one.at("case").get<std::uint64_t>();
    return number < wanted.from || number - wanted.from >= wanted.count ||
           (wanted.stratum && one.at("stratum") != to_string(*wanted.stratum));
  });
  std::sort(cases.begin(), cases.end(), [](const Json& a, const Json& b) {
    return a.at("case").get<std::uint64_t>() < b.at("case").get<std::uint64_t>();
  });
  std::printf("%s", everywhere_table(cases).c_str());
  std::fprintf(stderr, "all figures: %s\n", run.file().c_str());
  return 0;
}
