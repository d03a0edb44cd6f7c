// SPDX-License-Identifier: GPL-3.0-or-later
// Time of `build` with one thread and with several, side by side, and whether the bytes are the
// same.
//   bench_jobs [--jobs N] [--rounds N] [--against PROGRAM] [LOG...]
// Without logs: tours of data/worlds by a robot with sonars and with a laser. PROGRAM is another
// build of roomatlas, which is run without --jobs: what its times are divided by. Each round runs
// all of them one after the other; medians of the rounds (default: 3).
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "accuracy/program.hpp"
#include "roomatlas/core/median.hpp"

namespace {

namespace fs = std::filesystem;
using roomatlas::median;
using roomatlas::bench::Finished;
using roomatlas::bench::run_program;
using roomatlas::bench::run_roomatlas;

struct Asked {
  std::string jobs = "2";
  int rounds = 3;
  std::string against;
  std::vector<fs::path> logs;
};

Asked asked(int argc, char** argv) {
  Asked result;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool has_value = i + 1 < argc;
    if (word == "--jobs" && has_value) {
      result.jobs = argv[++i];
    } else if (word == "--rounds" && has_value) {
      result.rounds = std::max(1, std::atoi(argv[++i]));
    } else if (word == "--against" && has_value) {
      result.against = argv[++i];
    } else {
      result.logs.emplace_back(word);
    }
  }
  return result;
}

/// A tour through a world, once.
fs::path toured(const fs::path& folder, const std::string& world, const std::string& sensor,
                const std::string& speed) {
  const fs::path out = folder / (world + "_" + sensor);
  const std::string file =
      (fs::path(ROOMATLAS_SOURCE_DIR) / "data/worlds" / (world + ".geojson")).string();
  const Finished simulated =
      run_roomatlas({"-q", "simulate", file, "--tour", "--odometry", "typical", "--sensor", sensor,
                     "--speed", speed, "-o", out.string()},
                    folder / "simulate.txt");
  if (simulated.exit_code != 0) std::printf("simulate: %s\n", simulated.complaint.c_str());
  return out / "mission.clf";
}

/// 57 rooms in an hour and more, ten in a few minutes.
std::vector<fs::path> tours(const fs::path& folder) {
  return {
      toured(folder, "afit_floor", "sonar", "0.7"), toured(folder, "afit_floor", "laser", "0.95"),
      toured(folder, "eight_rooms", "sonar", "0.4"), toured(folder, "eight_rooms", "laser", "0.4")};
}

using Files = std::map<std::string, std::string>;

Files files_in(const fs::path& folder) {
  Files files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ifstream in(entry.path(), std::ios::binary);
    files[fs::relative(entry.path(), folder).string()] = {std::istreambuf_iterator<char>(in), {}};
  }
  return files;
}

/// Runs of one program on one log.
struct Times {
  std::vector<double> processor_s;
  std::vector<double> elapsed_s;
  Files files;

  void add(const Finished& run, const fs::path& out) {
    if (run.exit_code != 0) std::printf("build: %s\n", run.complaint.c_str());
    processor_s.push_back(run.processor_s);
    elapsed_s.push_back(run.elapsed_s);
    files = files_in(out);
  }
};

void print(const char* name, const Times& times, const Times& to) {
  std::printf("  %-12s processor %7.2f s (1/%.2f)  time %7.2f s (1/%.2f)  %s\n", name,
              median(times.processor_s), median(to.processor_s) / median(times.processor_s),
              median(times.elapsed_s), median(to.elapsed_s) / median(times.elapsed_s),
              times.files == to.files ? "the same bytes" : "OTHER BYTES");
}

void measure(const Asked& ask, const fs::path& log, const fs::path& folder) {
  Times before;
  Times one;
  Times several;
  const fs::path out = folder / "out";
  const fs::path said = folder / "build.txt";
  const std::vector<std::string> build = {"-q", "build", log.string(), "-o", out.string()};
  const auto with_jobs = [&](const std::string& jobs) {
    std::vector<std::string> words = build;
    words.insert(words.end(), {"--jobs", jobs});
    return words;
  };
  for (int round = 0; round < ask.rounds; ++round) {
    if (!ask.against.empty()) {
      fs::remove_all(out);
      before.add(run_program(ask.against, build, said), out);
    }
    fs::remove_all(out);
    one.add(run_roomatlas(with_jobs("1"), said), out);
    fs::remove_all(out);
    several.add(run_roomatlas(with_jobs(ask.jobs), said), out);
  }
  std::printf("%s\n", (log.parent_path().filename() / log.filename()).c_str());
  const Times& to = ask.against.empty() ? one : before;
  if (!ask.against.empty()) print("before", before, to);
  print("1 job", one, to);
  print((ask.jobs + " jobs").c_str(), several, to);
  std::printf("  %s jobs against one: time 1/%.2f\n", ask.jobs.c_str(),
              median(one.elapsed_s) / median(several.elapsed_s));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  std::string name = (fs::temp_directory_path() / "bench_jobs-XXXXXX").string();
  const fs::path folder = mkdtemp(name.data());
  const Asked ask = asked(argc, argv);
  for (const fs::path& log : ask.logs.empty() ? tours(folder) : ask.logs) {
    measure(ask, log, folder);
  }
  fs::remove_all(folder);
  return 0;
}
