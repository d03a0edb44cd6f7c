// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's experiment (Fig. 8 and 10) many times over: a robot explores a world by itself with
// drifting odometry, its log is mapped and corrected, and the result is compared with the truth.
//   paper_seeds WORLD.geojson [SEEDS [sonar|laser [mild|typical|hard]]]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <thread>
#include <vector>

#include "roomatlas/io/formats.hpp"
#include "roomatlas/pipeline/pipeline.hpp"
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
  const PlacedMission placed = place(store, assembly.correction);
  Truth truth;
  truth.plan = world;
  for (const TruePose& pose : store.truth()) {
    truth.poses.push_back({pose.timestamp_s, pose.world_from_robot});
  }
  outcome.evaluation = evaluate(placed.odometry, placed.corrected, assembly.plan, truth);
  judge_placements(store, assembly.correction, assembly.plan, truth, outcome.evaluation);
  return outcome;
}

/// Every `stride`-th seed from `first` on.
void run_some(const FloorPlan& world, const SimulationOptions& simulation, std::size_t first,
              std::size_t stride, std::vector<Outcome>& outcomes) {
  for (std::size_t i = first; i < outcomes.size(); i += stride) {
    try {
      outcomes[i] = run(world, simulation, i + 1);
    } catch (const std::exception& error) {
      outcomes[i].failure = error.what();
    }
  }
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

/// Prints one row a seed and the medians of the columns.
void print(const FloorPlan& world, const std::vector<Outcome>& outcomes) {
  std::printf(
      "| seed | rooms entered | collisions | path | isomorphic | edits | rooms F1 | doors F1 | "
      "door "
      "position | room rotation before, after | position before, after | fitted |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  int isomorphic = 0;
  std::vector<std::vector<double>> columns(10);
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const Outcome& outcome = outcomes[i];
    if (!outcome.failure.empty()) {
      std::printf("| %zu | failed: %s |\n", i + 1, outcome.failure.c_str());
      continue;
    }
    const Evaluation& judged = outcome.evaluation;
    const PlanErrors& plan = *judged.plan;
    isomorphic += plan.graph->isomorphic ? 1 : 0;
    const std::vector<double> row = {outcome.drive.path_length_m,
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
      if (std::isfinite(row[c])) columns[c].push_back(row[c]);
    }
    std::printf(
        "| %zu | %zu of %zu | %d | %.0f m | %s | %.0f | %.2f | %.2f | %s | %.2f, %.2f deg | "
        "%.2f, %.2f m | %.3f m |\n",
        i + 1, outcome.drive.entered.size(), world.rooms.size(), outcome.drive.collisions, row[0],
        plan.graph->isomorphic ? "yes" : "no", row[1], row[2], row[3], metres(row[4]).c_str(),
        row[5], row[6], row[7], row[8], row[9]);
  }
  const auto middle = [&](std::size_t column) { return median(columns[column]); };
  std::printf(
      "| median | | | %.0f m | %d of %zu | %.0f | %.2f | %.2f | %.2f m | %.2f, %.2f deg | %.2f, "
      "%.2f m | %.3f m |\n",
      middle(0), isomorphic, outcomes.size(), middle(1), middle(2), middle(3), middle(4), middle(5),
      middle(6), middle(7), middle(8), middle(9));
}

OdometryPreset preset_of(const std::string& name) {
  if (name == "mild") return OdometryPreset::mild;
  if (name == "hard") return OdometryPreset::hard;
  return OdometryPreset::typical;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: paper_seeds WORLD.geojson [SEEDS [SENSOR [ODOMETRY]]]\n");
    return 2;
  }
  const FloorPlan world = read_plan(argv[1]);
  const int seeds = argc > 2 ? std::max(1, std::atoi(argv[2])) : 20;
  SimulationOptions simulation;
  if (argc > 3 && std::string(argv[3]) == "laser") simulation.sensor = SensorKind::laser;
  simulation.odometry = odometry_errors(preset_of(argc > 4 ? argv[4] : "typical"));

  std::vector<Outcome> outcomes(static_cast<std::size_t>(seeds));
  const std::size_t workers = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::thread> threads;
  for (std::size_t worker = 0; worker < workers; ++worker) {
    threads.emplace_back([&, worker] { run_some(world, simulation, worker, workers, outcomes); });
  }
  for (std::thread& thread : threads) thread.join();
  print(world, outcomes);
  return 0;
}
