// SPDX-License-Identifier: GPL-3.0-or-later
// Learns how far a map can be relied on, and checks what a program says of its maps; from what
// `bench_everywhere` wrote.
//
//   bench_trust train laser|sonar FILE...   prints src/trust/laser_model.cpp, or sonar_model.cpp
//   bench_trust bars laser|sonar FILE...    prints the error bars of these files alone
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
  const bool bars = words.size() > 2 && words[0] == "bars";
  const bool checks = words.size() > 1 && words[0] == "check";
  if (!trains && !bars && !checks) {
    std::fprintf(stderr, "bench_trust train|bars laser|sonar FILE..., or check FILE...\n");
    return 2;
  }
  const std::vector<bench::TrustSample> samples =
      bench::read_samples({words.begin() + (checks ? 1 : 2), words.end()});
  if (checks) {
    std::printf("%s", bench::trust_tables(samples).c_str());
    return 0;
  }
  const SensorKind sensor = words[1] == "sonar" ? SensorKind::sonar : SensorKind::laser;
  const std::string source = trains ? bench::learnt_source(bench::learn_trust(samples, sensor))
                                    : bench::bars_source(bench::learn_bars(samples, sensor));
  std::printf("%s", source.c_str());
  return 0;
}
