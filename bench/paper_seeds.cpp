// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's experiment (Fig. 8 and 10) many times over: a robot explores a world by itself with
// drifting odometry, its log is mapped and corrected, and the result is compared with the truth.
//   paper_seeds WORLD.geojson [SEEDS [sonar|laser [mild|typical|hard [FIRST_SEED]]]]
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "roomatlas/asr/with_paths.hpp"
#include "roomatlas/correct/place.hpp"
#include "roomatlas/evaluate/evaluation.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "roomatlas/pipeline/assemble.hpp"
#include "roomatlas/pipeline/map_mission.hpp"
#include "roomatlas/simulate/explore.hpp"
#include "support/memory_mission.hpp"
#include "support/memory_store.hpp"

namespace {

using namespace roomatlas;

struct Outcome {
  ExploreSummary drive;
  Evaluation evaluation;
  std::string failure;  ///< empty where all went well
};

Outcome run(const FloorPlan& world, SimulationOptions simulation, std::uint64_t seed) {
  simulation.seed = seed;
  Outcome outcome;
  std::vector<MissionEvent> events;
  outcome.drive = explore(world, simulation, {}, [&](const SimulatedStep& step) {
    events.emplace_back(step.reading);
    events.emplace_back(step.truth);
  });
  test::MemoryMission mission(std::move(events));
  test::MemoryStore store;
  (void)map_mission(mission, store, {});
  const Assembly assembly = assemble(store, simulation.footprint, {});
  if (!assembly.mapped_again.empty()) store.asrs = assembly.mapped_again;
  const WithPaths matched(store, assembly.paths);
  const PlacedMission placed = place(matched, assembly.correction);
  Truth truth;
  truth.plan = world;
  for (const TruePose& pose : store.truth()) {
    truth.poses.push_back({pose.timestamp_s, pose.world_from_robot});
  }
  outcome.evaluation = evaluate(placed.odometry, placed.corrected, assembly.plan, truth);
  judge_placements(matched, assembly.correction, assembly.plan, truth, outcome.evaluation);
  return outcome;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2.0;
}

/// "none" for what is the mean of nothing.
std::string metres(double length_m) {
  if (!std::isfinite(length_m)) return "none";
  char text[32];
  (void)std::snprintf(text, sizeof text, "%.2f m", length_m);
  return text;
}

/// The table: a row as soon as it and all before it are known, the medians at the end.
class Table {
 public:
  Table(std::size_t rooms, std::uint64_t first_seed, std::size_t seeds)
      : rooms_(rooms), first_seed_(first_seed), outcomes_(seeds) {
    std::printf(
        "| seed | rooms entered | collisions | path | isomorphic | edits | rooms F1 | doors F1 | "
        "door position | room rotation before, after | position before, after | fitted |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    std::fflush(stdout);
  }

  /// Takes the outcome of the `i`-th seed; from any thread.
  void take(std::size_t i, Outcome outcome) {
    const std::lock_guard lock(mutex_);
    outcomes_[i] = std::move(outcome);
    for (; printed_ < outcomes_.size() && outcomes_[printed_]; ++printed_) {
      print_row(first_seed_ + printed_, *outcomes_[printed_]);
    }
    std::fflush(stdout);
  }

  void print_medians() const {
    const auto middle = [&](std::size_t column) { return median(columns_[column]); };
    std::printf(
        "| median | | | %.0f m | %d of %zu | %.0f | %.2f | %.2f | %.2f m | %.2f, %.2f deg | %.2f, "
        "%.2f m | %.3f m |\n",
        middle(0), isomorphic_, outcomes_.size(), middle(1), middle(2), middle(3), middle(4),
        middle(5), middle(6), middle(7), middle(8), middle(9));
  }

 private:
  void print_row(std::uint64_t seed, const Outcome& outcome) {
    const auto seed_number = static_cast<unsigned long long>(seed);
    if (!outcome.failure.empty()) {
      std::printf("| %llu | failed: %s |\n", seed_number, outcome.failure.c_str());
      return;
    }
    const Evaluation& judged = outcome.evaluation;
    const PlanErrors& plan = *judged.plan;
    isomorphic_ += plan.graph->isomorphic ? 1 : 0;
    const std::array<double, 10> row = {outcome.drive.path_length_m,
                                        static_cast<double>(plan.graph->edits()),
                                        plan.f1,
                                        plan.door_score.f1,
                                        plan.mean_door_distance_m,
                                        judged.room_poses->before.rotation_deg.median,
                                        judged.room_poses->after.rotation_deg.median,
                                        judged.true_poses->before.position_m.mean,
                                        judged.true_poses->after.position_m.mean,
                                        judged.true_poses->after.fitted_position_m.mean};
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (std::isfinite(row[c])) columns_[c].push_back(row[c]);
    }
    std::printf(
        "| %llu | %zu of %zu | %d | %.0f m | %s | %.0f | %.2f | %.2f | %s | %.2f, %.2f deg | "
        "%.2f, %.2f m | %.3f m |\n",
        seed_number, outcome.drive.entered.size(), rooms_, outcome.drive.collisions, row[0],
        plan.graph->isomorphic ? "yes" : "no", row[1], row[2], row[3], metres(row[4]).c_str(),
        row[5], row[6], row[7], row[8], row[9]);
  }

  std::size_t rooms_;
  std::uint64_t first_seed_;
  std::vector<std::optional<Outcome>> outcomes_;
  std::array<std::vector<double>, 10> columns_;
  std::size_t printed_ = 0;
  int isomorphic_ = 0;
  std::mutex mutex_;
};

Outcome run_or_fail(const FloorPlan& world, const SimulationOptions& simulation,
                    std::uint64_t seed) {
  try {
    return run(world, simulation, seed);
  } catch (const std::exception& error) {
    Outcome outcome;
    outcome.failure = error.what();
    return outcome;
  }
}

OdometryPreset preset_of(const std::string& name) {
  if (name == "mild") return OdometryPreset::mild;
  if (name == "hard") return OdometryPreset::hard;
  return OdometryPreset::typical;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: paper_seeds WORLD.geojson [SEEDS [SENSOR [ODOMETRY [FIRST]]]]\n");
    return 2;
  }
  const FloorPlan world = read_plan(argv[1]);
  const auto seeds = static_cast<std::size_t>(argc > 2 ? std::max(1, std::atoi(argv[2])) : 20);
  SimulationOptions simulation;
  if (argc > 3 && std::string(argv[3]) == "laser") simulation.sensor = SensorKind::laser;
  simulation.odometry = odometry_errors(preset_of(argc > 4 ? argv[4] : "typical"));
  const auto first = static_cast<std::uint64_t>(argc > 5 ? std::max(1, std::atoi(argv[5])) : 1);

  Table table(world.rooms.size(), first, seeds);
  std::atomic<std::size_t> next = 0;
  std::vector<std::thread> threads;
  for (unsigned worker = 0; worker < std::max(1U, std::thread::hardware_concurrency()); ++worker) {
    threads.emplace_back([&] {
      for (std::size_t i = next++; i < seeds; i = next++) {
        table.take(i, run_or_fail(world, simulation, first + i));
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  table.print_medians();
  return 0;
}
