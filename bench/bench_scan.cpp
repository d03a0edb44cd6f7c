// SPDX-License-Identifier: GPL-3.0-or-later
// What a laser scan costs the online stage, in the first and in the last quarter of recorded logs.
// Processor time, of the thread that takes the readings, between handing out one and being asked
// for the next; a room that was left is mapped in a thread of its own.
//   bench_scan [LOG...]
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

#include "recorded_data.hpp"
#include "roomatlas/io/logs/open_mission.hpp"
#include "roomatlas/pipeline/map_mission.hpp"

namespace {

using namespace roomatlas;

double now_ms() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

double quantile(std::vector<double> values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Notes how long each reading is worked on. Reading the log does not count.
class TimedMission : public MissionSource {
 public:
  explicit TimedMission(MissionSource& mission) : mission_(mission) {}
  std::optional<MissionEvent> next() override {
    if (handed_out_ms_) costs_ms.push_back(now_ms() - *handed_out_ms_);
    std::optional<MissionEvent> event = mission_.next();
    const bool is_reading = event && std::holds_alternative<RangeReading>(*event);
    handed_out_ms_ = is_reading ? std::optional<double>(now_ms()) : std::nullopt;
    return event;
  }
  [[nodiscard]] const MissionInfo& info() const override { return mission_.info(); }
  [[nodiscard]] double progress() const override { return mission_.progress(); }

  std::vector<double> costs_ms;

 private:
  MissionSource& mission_;
  std::optional<double> handed_out_ms_;
};

/// ASRs go nowhere: the disk is not what is asked about.
struct Nowhere : AsrSink {
  void put(const Asr&) override {}
  void put(const TruePose&) override {}
};

void time_log(const std::filesystem::path& log) {
  const auto mission = open_mission(log, {});
  TimedMission timed(*mission);
  Nowhere sink;
  (void)map_mission(timed, sink, {});
  const auto& all = timed.costs_ms;
  const auto quarter = static_cast<std::ptrdiff_t>(all.size() / 4);
  const std::vector<double> first(all.begin(), all.begin() + quarter);
  const std::vector<double> last(all.end() - quarter, all.end());
  double sum = 0.0;
  for (const double cost : all) sum += cost;
  std::printf("| %s | %zu | %.2f | %.2f, %.2f | %.2f, %.2f | %.1f |\n",
              log.filename().string().c_str(), all.size(), sum / static_cast<double>(all.size()),
              quantile(first, 0.5), quantile(last, 0.5), quantile(first, 0.99),
              quantile(last, 0.99), quantile(all, 1.0));
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::filesystem::path> logs(argv + 1, argv + argc);
  if (logs.empty()) {
    for (const char* log : {"fr079/fr079.clf.gz", "aces/aces.clf.gz",
                            "mit-killian/mit-killian.reconstructed.clf.gz"}) {
      logs.push_back(bench::recorded_data() / "logs" / log);
    }
  }
  std::printf(
      "| log | scans | mean (ms) | median: first, last quarter | 99 %% | most |\n"
      "|---|---|---|---|---|---|\n");
  try {
    for (const auto& log : logs) time_log(log);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_scan: %s\n", error.what());
    return 3;
  }
}
