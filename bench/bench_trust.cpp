// SPDX-License-Identifier: GPL-3.0-or-later
// Learns how far a map can be relied on, and checks what a program says of its maps; from what
// `bench_everywhere` wrote.
//
//   bench_trust train laser|sonar FILE...   prints src/trust/laser_model.cpp, or sonar_model.cpp
//   bench_trust check FILE...               tables: probabilities and error bars that the program
//                                           gave against the truth
//     FILE   cases.jsonl of a run; missions to check on should be no missions that were learnt from
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "trust/check_trust.hpp"
#include "trust/learn_trust.hpp"
#include "trust/trust_samples.hpp"

int main(int argc, char** argv) {
  using namespace roomatlas;
  const std::vector<std::string> words(argv + 1, argv + argc);
  const bool trains = words.size() > 2 && words[0] == "train";
  const bool checks = words.size() > 1 && words[0] == "check";
  if (!trains && !checks) {
    std::fprintf(stderr, "bench_trust train laser|sonar FILE..., or bench_trust check FILE...\n");
    return 2;
  }
  const std::vector<bench::TrustSample> samples =
      bench::read_samples({words.begin() + (trains ? 2 : 1), words.end()});
  if (checks) {
    std::printf("%s", bench::trust_tables(samples).c_str());
    return 0;
  }
  const SensorKind sensor = words[1] == "sonar" ? SensorKind::sonar : SensorKind::laser;
  std::printf("%s", bench::learnt_source(bench::learn_trust(samples, sensor)).c_str());
  return 0;
}
