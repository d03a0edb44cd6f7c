// SPDX-License-Identifier: GPL-3.0-or-later
// Time of `roomatlas-fleet` with one rank and with two, and whether the bytes are the same.
//   bench_fleet [MISSIONS [WORLD]]
// Tours of a world of data/worlds by a robot with a laser, each with another seed (default: 40 of
// eight_rooms). Each rank has one thread. A machine with other work on it shows less than there is.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "accuracy/program.hpp"

namespace {

namespace fs = std::filesystem;
using roomatlas::bench::Finished;
using roomatlas::bench::run_program;
using roomatlas::bench::run_roomatlas;

fs::path simulated(const fs::path& folder, const std::string& world, int seed) {
  const fs::path out = folder / ("mission" + std::to_string(seed));
  const fs::path file = fs::path(ROOMATLAS_SOURCE_DIR) / "data/worlds" / (world + ".geojson");
  const Finished made =
      run_roomatlas({"-q", "simulate", file.string(), "--tour", "--sensor", "laser", "--odometry",
                     "typical", "--seed", std::to_string(seed), "-o", out.string()},
                    folder / "simulate.txt");
  if (made.exit_code != 0) std::printf("simulate: %s\n", made.complaint.c_str());
  const fs::path log = folder / ("m" + std::to_string(seed) + ".clf");
  fs::rename(out / "mission.clf", log);
  return log;
}

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

double seconds_of(int ranks, const std::vector<fs::path>& logs, const fs::path& folder) {
  fs::remove_all(folder);
  fs::create_directories(folder);
  std::vector<std::string> words = {
      "--oversubscribe", "-n", std::to_string(ranks), ROOMATLAS_FLEET, "-q", "--jobs", "1"};
  for (const fs::path& log : logs) words.push_back(log.string());
  words.insert(words.end(), {"-o", (folder / "building.gpkg").string()});
  const auto from = std::chrono::steady_clock::now();
  const Finished done = run_program(ROOMATLAS_MPIRUN, words, folder / "said.txt");
  if (done.exit_code != 0) std::printf("%d ranks: %s\n", ranks, done.complaint.c_str());
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
}

}  // namespace

int main(int argc, char** argv) {
  const int missions = argc > 1 ? std::atoi(argv[1]) : 40;
  const std::string world = argc > 2 ? argv[2] : "eight_rooms";
  setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
  setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
  const fs::path folder = fs::temp_directory_path() / "roomatlas_bench_fleet";
  fs::create_directories(folder);
  std::vector<fs::path> logs;
  for (int seed = 1; seed <= missions; ++seed) logs.push_back(simulated(folder, world, seed));
  const double one_s = seconds_of(1, logs, folder / "one");
  const double two_s = seconds_of(2, logs, folder / "two");
  const std::string one = content_of(folder / "one/building.gpkg");
  const bool is_same = !one.empty() && one == content_of(folder / "two/building.gpkg");
  std::printf("%d missions of %s: 1 rank %.1f s, 2 ranks %.1f s: %.2f times as fast; bytes %s\n",
              missions, world.c_str(), one_s, two_s, one_s / two_s,
              is_same ? "the same" : "DIFFER");
  fs::remove_all(folder);
  return is_same ? 0 : 1;
}
