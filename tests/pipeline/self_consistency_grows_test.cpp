// SPDX-License-Identifier: GPL-3.0-or-later
// The figures without truth get worse, in order, as known wrong corrections grow.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "pipeline/known_placement.hpp"
#include "pipeline/memory_mission.hpp"
#include "roomatlas/evaluate/self_consistency.hpp"
#include "roomatlas/io/logs/drive.hpp"
#include "roomatlas/io/logs/open_mission.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "roomatlas/pipeline/assemble.hpp"
#include "roomatlas/pipeline/map_mission.hpp"
#include "roomatlas/rooms/assign_rooms.hpp"
#include "roomatlas/simulate/explore.hpp"
#include "support/shared_data.hpp"
#include "support/shipped_world.hpp"

namespace roomatlas {
namespace {

using namespace test;

/// A mapped mission and where its ASRs truly are.
struct KnownMission {
  MemoryStore store;
  Trajectory truth_path;
  std::vector<AsrEvidence> evidence;
  Placement truth;
  Placement odometry;
  std::map<AsrId, RoomId> rooms;
  ConsistencyOptions options;
};

/// Half of the sweeps and two thirds of the beams, for a large mission.
ConsistencyOptions quick() {
  ConsistencyOptions options;
  options.evidence.sweeps_per_asr = 20;
  options.evidence.beams_per_sweep = 40;
  return options;
}

KnownMission known(MemoryStore store, const Trajectory& truth,
                   const ConsistencyOptions& options = {}) {
  KnownMission mission{std::move(store), truth, {}, {}, {}, {}, options};
  const std::vector<Asr> asrs = all_of(mission.store);
  mission.evidence = evidence_of(mission.store, options.evidence);
  mission.truth = true_placement(asrs, truth);
  mission.odometry = odometry_placement(asrs);
  mission.rooms = assign_rooms(asrs, build_graph(asrs), mission.truth, {});
  return mission;
}

KnownMission recorded(const std::filesystem::path& log, const Trajectory& truth,
                      const ConsistencyOptions& consistency = {}, bool localize = true) {
  MapOptions options;
  options.localize.enabled = localize;
  MemoryStore store;
  const auto mission = open_mission(log, {});
  (void)map_mission(*mission, store, options);
  return known(std::move(store), truth, consistency);
}

KnownMission simulated(const std::vector<MissionEvent>& events) {
  MemoryStore store = mapped(events);
  Trajectory truth;
  for (const TruePose& pose : store.true_poses) {
    truth.push_back({pose.timestamp_s, pose.world_from_robot});
  }
  return known(std::move(store), truth);
}

/// Adds a simulator's steps to a mission.
auto into(std::vector<MissionEvent>& events) {
  return [&events](const SimulatedStep& step) {
    events.emplace_back(step.reading);
    events.emplace_back(step.truth);
  };
}

KnownMission driven(const std::string& world) {
  const Path drive = Path(ROOMATLAS_SOURCE_DIR) / "data" / "worlds" / (world + ".drive");
  std::vector<MissionEvent> events;
  simulate(test::shipped_world(world), read_drive(drive), {}, into(events));
  return simulated(events);
}

/// A robot with a laser explores by itself, ten minutes at most.
KnownMission explored(const std::string& world) {
  SimulationOptions options;
  options.sensor = SensorKind::laser;
  options.odometry = odometry_errors(OdometryPreset::typical);
  ExploreOptions ten_minutes;
  ten_minutes.max_time_s = 600.0;
  std::vector<MissionEvent> events;
  (void)explore(test::shipped_world(world), options, ten_minutes, into(events));
  return simulated(events);
}

SelfConsistency judged(const KnownMission& mission, const Placement& placement) {
  return self_consistency(mission.evidence, placement, mission.rooms, mission.options);
}

/// Two standard errors of a share of so many samples.
double noise_of(const ConsistencyValue& share) {
  return 2.0 * std::sqrt(share.value * (1.0 - share.value) / share.measured);
}

/// Every step of growing error raises the sum of the figures, and that of walls that rays pass
/// through but for the noise of a share that has levelled off; and each wrong map is judged worse
/// than the true one.
template <typename Wrong>
void expect_growth(const KnownMission& mission, const std::vector<double>& sizes, Wrong wrong) {
  const SelfConsistency right = judged(mission, mission.truth);
  SelfConsistency former = right;
  const auto rays = static_cast<std::size_t>(ConsistencyFigure::rays_through_walls);
  for (const double size : sizes) {
    const SelfConsistency now = judged(mission, wrong(size));
    EXPECT_GT(now.inconsistency, former.inconsistency) << "at " << size;
    if (size >= sizes[1]) {
      const ConsistencyValue& share = now.figures[rays];
      EXPECT_GE(share.value, former.figures[rays].value - noise_of(share)) << "at " << size;
      EXPECT_GE(share.value, right.figures[rays].value) << "at " << size;
    }
    former = now;
  }
  EXPECT_EQ(compare(right, former, {.before_is_odometry = false}).verdict, Verdict::worse);
}

void expect_order(const KnownMission& mission) {
  const std::vector<double> angles_deg = {1, 2, 5, 10};
  std::set<RoomId> rooms;
  for (const auto& [asr, room] : mission.rooms) rooms.insert(room);
  if (rooms.size() > 1) {  // the only room of a building, turned as a whole, is the same map
    expect_growth(mission, angles_deg, [&](double angle_deg) {
      return rooms_turned(mission.truth, mission.rooms, angle_deg);
    });
  }
  expect_growth(mission, angles_deg, [&](double angle_deg) {
    return visits_turned(mission.truth, mission.rooms, angle_deg);
  });
  expect_growth(mission, {0.25, 0.5, 1, 2},
                [&](double size_m) { return false_loop(mission.truth, size_m); });
}

void expect_better_than_odometry(const KnownMission& mission, const Placement& placement) {
  const ConsistencyComparison comparison =
      compare(judged(mission, mission.odometry), judged(mission, placement), {});
  EXPECT_EQ(comparison.verdict, Verdict::better);
}

/// The map that the pipeline itself makes, of the ASRs that it ends with: with sonars it records
/// them again.
void expect_pipeline_better_than_odometry(KnownMission mission, const Options& options = {}) {
  Assembly assembly = assemble(mission.store, {}, options);
  if (!assembly.mapped_again.empty()) {
    mission.store.asrs = std::move(assembly.mapped_again);
    mission = known(std::move(mission.store), mission.truth_path, mission.options);
  }
  expect_better_than_odometry(mission, placement_of(assembly.correction));
}

TEST(SelfConsistencyGrows, WithTheErrorsOfASimulatedWorld) {
  const KnownMission mission = driven("eight_rooms");
  expect_order(mission);
  expect_better_than_odometry(mission, mission.truth);
  expect_pipeline_better_than_odometry(mission);
}

class SelfConsistencyOfWorlds : public testing::TestWithParam<const char*> {};

TEST_P(SelfConsistencyOfWorlds, GrowsWithTheErrors) {
  const KnownMission mission = explored(GetParam());
  expect_order(mission);
  // Two pieces and one door: nothing was seen again that odometry could have misplaced, and the
  // verdict on it is chance.
  if (mission.truth.size() > 2) expect_better_than_odometry(mission, mission.truth);
}

INSTANTIATE_TEST_SUITE_P(Shipped, SelfConsistencyOfWorlds,
                         testing::Values("two_rooms", "nine_rooms", "identical_rooms",
                                         "slanted_and_curved", "open_hall", "afit_floor"),
                         [](const auto& world) { return std::string(world.param); });

TEST(SelfConsistencyGrows, WithTheErrorsOfFr079) {
  const auto raw = shared_data("logs/fr079/fr079.clf.gz");
  const auto truth = shared_data("logs/fr079/fr079.gfs-corrected.log.gz");
  if (!raw || !truth) return;
  const KnownMission mission = recorded(*raw, poses_of_corrected_log(*raw, *truth), quick());
  expect_order(mission);
  expect_better_than_odometry(mission, mission.truth);
}

TEST(SelfConsistencyGrows, WithTheErrorsOfAces) {
  const auto raw = shared_data("logs/aces/aces.clf.gz");
  const auto truth = shared_data("logs/aces/aces.gfs-corrected.log.gz");
  if (!raw || !truth) return;
  const KnownMission mission = recorded(*raw, poses_of_corrected_log(*raw, *truth));
  expect_order(mission);
  expect_better_than_odometry(mission, mission.truth);
  Options matches_alone;  // a doubted map is corrected as a whole, which takes a minute
  matches_alone.assemble.correct_sonars = false;
  expect_pipeline_better_than_odometry(mission, matches_alone);
}

TEST(SelfConsistencyGrows, WithTheErrorsOfMitCsail) {
  const auto raw = shared_data("logs/mit-csail/mit-csail.clf.gz");
  const auto truth = shared_data("logs/mit-csail/mit-csail.corrected-poses.txt");
  if (!raw || !truth) return;
  // The poses beside this log are a mapper's and place localized rooms no better than to 2 degrees:
  // the sum would not tell 1 from 2 degrees. Rooms as odometry bent them are judged here.
  const KnownMission mission = recorded(*raw, poses_of_table(*truth), {}, false);
  expect_order(mission);
  expect_better_than_odometry(mission, mission.truth);
}

}  // namespace
}  // namespace roomatlas
