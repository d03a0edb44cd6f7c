// SPDX-License-Identifier: GPL-3.0-or-later
// What the online stage costs: time of a step against the number of rooms mapped so far, and bytes
// of rooms as grid and as geometry (paper section V, Fig. 9).
//
//   bench_online [ROOMS]    default: 1000
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <map>
#include <memory>
#include <vector>

#include "roomatlas/asr/recorder.hpp"
#include "roomatlas/io/logs/drive.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/simulate/simulate.hpp"
#include "row_of_rooms.hpp"

namespace {

using namespace roomatlas;
using namespace roomatlas::bench;

/// Passes ASRs on and adds up their bytes.
class CountingSink : public AsrSink {
 public:
  explicit CountingSink(AsrSink& sink) : sink_(sink) {}
  void put(const Asr& asr) override {
    ++asrs;
    vertices += asr.counters.vertices;
    geometry_bytes += asr.counters.geometry_bytes;
    grid_bytes += asr.counters.grid_bytes;
    sink_.put(asr);
  }
  void put(const TruePose&) override {}

  std::int64_t asrs = 0;
  std::int64_t vertices = 0;
  std::int64_t geometry_bytes = 0;
  std::int64_t grid_bytes = 0;

 private:
  AsrSink& sink_;
};

/// Of this thread's processor time, which other programs disturb least.
double now_us() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

double quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

/// A mission on its way along the row.
class Mission {
 public:
  Mission(const Row& row, AsrSink& sink)
      : drive_(row, 0.1), recorder_({}, RobotFootprint{}, sink) {}

  /// Takes the next reading; returns what that cost.
  double step_us() {
    const RangeReading reading = drive_.next();
    const double before_us = now_us();
    recorder_.add(reading, reading.odom_from_robot);
    const double cost_us = now_us() - before_us;
    ++steps_;
    return cost_us;
  }
  void finish() { recorder_.finish(); }
  [[nodiscard]] int room() const { return drive_.room(); }  ///< of the next reading, from 1
  [[nodiscard]] std::int64_t steps() const { return steps_; }

 private:
  RowDrive drive_;
  AsrRecorder recorder_;
  std::int64_t steps_ = 0;
};

struct StepCosts {
  std::vector<double> early_us;  ///< in rooms 6 to 10
  std::vector<double> late_us;   ///< in the last five rooms
};

/// A second mission drives its rooms 1 to 10 in step with the last ten of the first, which are the
/// same rooms: whatever else the machine does meanwhile disturbs both alike.
StepCosts drive_in_step(Mission& longer, Mission& shorter, int rooms) {
  StepCosts costs;
  while (longer.room() <= rooms - 10) (void)longer.step_us();
  while (longer.room() <= rooms) {
    const bool counts = shorter.room() >= 6;
    const bool longer_first = longer.steps() % 2 == 0;
    double late_us = longer_first ? longer.step_us() : 0.0;
    const double early_us = shorter.step_us();
    if (!longer_first) late_us = longer.step_us();
    if (!counts) continue;
    costs.early_us.push_back(early_us);
    costs.late_us.push_back(late_us);
  }
  longer.finish();
  shorter.finish();
  return costs;
}

void bench_steps(int rooms) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / "roomatlas_bench_online";
  fs::create_directories(folder);
  const fs::path file = folder / "building.gpkg";
  std::printf("A mission through %d equal rooms, 16 sonars, mild odometry, ASRs to a store.\n",
              rooms);
  const Row row;
  {
    GeoPackageStore store(file, GeoPackageStore::Mode::create);
    GeoPackageStore short_store(folder / "short.gpkg", GeoPackageStore::Mode::create);
    CountingSink sink(store);
    CountingSink short_sink(short_store);
    Mission longer(row, sink);
    Mission shorter(row, short_sink);
    const StepCosts cost = drive_in_step(longer, shorter, rooms);
    store.finish();
    const double whole =
        rooms * kPeriod * (kRoomY + 2.0 * kWall) / 0.01;  // one byte a cell of 0.1 m
    std::printf("steps %lld, ASRs %lld\n\n", static_cast<long long>(longer.steps()),
                static_cast<long long>(sink.asrs));
    std::printf("%-28s %10s %10s\n", "microseconds a step", "median", "99 %");
    std::printf("%-28s %10.1f %10.1f\n", "rooms 6 to 10", quantile(cost.early_us, 0.5),
                quantile(cost.early_us, 0.99));
    std::printf("%-19s %3d to %d %9.1f %10.1f\n", "rooms", rooms - 4, rooms,
                quantile(cost.late_us, 0.5), quantile(cost.late_us, 0.99));
    std::printf("ratio of the medians: %.3f (at most 1.05)\n\n",
                quantile(cost.late_us, 0.5) / quantile(cost.early_us, 0.5));
    std::printf("one grid of the whole, one byte a cell: %.0f bytes\n", whole);
    std::printf("grids of the ASRs, one byte a cell:     %lld bytes\n",
                static_cast<long long>(sink.grid_bytes));
    std::printf(
        "walls of the ASRs, vertices x 2 x 4:    %lld bytes (%.1f a room, 1/%.0f of one grid)\n",
        static_cast<long long>(sink.geometry_bytes),
        static_cast<double>(sink.geometry_bytes) / rooms,
        whole / static_cast<double>(sink.geometry_bytes));
    std::printf("the store with paths and readings:      %llu bytes\n\n",
                static_cast<unsigned long long>(fs::file_size(file)));
  }
  fs::remove_all(folder);
}

/// Keeps ASRs.
struct Asrs : AsrSink {
  void put(const Asr& asr) override { asrs.push_back(asr); }
  void put(const TruePose&) override {}
  std::vector<Asr> asrs;
};

struct Bytes {
  int asrs = 0;
  std::int64_t grid = 0;
  std::int64_t walls = 0;
  std::int64_t vertices = 0;
  std::size_t outline_vertices = 0;
};

/// Bytes of the rooms of `nine_rooms` that the drive goes through, by the room's id. An ASR is of
/// the room in which most of its path truly is.
std::map<RoomId, Bytes> bytes_of_nine_rooms(std::uint64_t seed, const RecorderOptions& options) {
  const Path folder = Path(ROOMATLAS_SOURCE_DIR) / "data/worlds";
  const FloorPlan world = read_plan(folder / "nine_rooms.geojson");
  SimulationOptions simulation;
  simulation.seed = seed;
  Asrs sink;
  std::map<double, Point2> truth;
  AsrRecorder recorder(options, RobotFootprint{}, sink);
  simulate(world, read_drive(folder / "../drives/nine_rooms_rooms_5_6.drive"), simulation,
           [&](const SimulatedStep& step) {
             recorder.add(step.reading, step.reading.odom_from_robot);
             truth[step.truth.timestamp_s] = step.truth.world_from_robot.position();
           });
  recorder.finish();
  std::map<RoomId, Bytes> bytes;
  for (const Asr& asr : sink.asrs) {
    std::map<RoomId, int> samples;
    for (const PathSample& sample : asr.path) {
      for (const PlanRoom& room : world.rooms) {
        if (contains(room.parts.front(), truth.at(sample.timestamp_s))) ++samples[room.id];
      }
    }
    const auto most = std::max_element(samples.begin(), samples.end(),
                                       [](auto& a, auto& b) { return a.second < b.second; });
    Bytes& of_room = bytes[most == samples.end() ? 0 : most->first];
    ++of_room.asrs;
    of_room.grid += asr.counters.grid_bytes;
    of_room.walls += asr.counters.geometry_bytes;
    of_room.vertices += asr.counters.vertices;
    of_room.outline_vertices += asr.outline_asr.outer.size();
    if (std::getenv("ROOMATLAS_BENCH_WALLS") != nullptr) {
      for (const WallPolyline& wall : asr.walls) {
        for (const Point2& p : wall.vertices_asr) {
          std::printf("W %lld %.2f %.2f\n", static_cast<long long>(asr.id), p.x(), p.y());
        }
        std::printf("\n");
      }
    }
  }
  return bytes;
}

void bench_nine_rooms() {
  constexpr std::uint64_t kSeeds = 5;
  std::printf(
      "Rooms 5 and 6 of nine_rooms, 16 sonars, mild odometry (paper Fig. 9: 42 KB as grid of\n"
      "16 bytes a cell, under 100 bytes as geometry, both rooms together).\n");
  std::printf("%5s %5s %6s %12s %12s %10s %18s\n", "seed", "room", "ASRs", "grid bytes", "vertices",
              "bytes", "outline vertices");
  std::map<RoomId, double> mean;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const auto bytes = bytes_of_nine_rooms(seed, {});
    for (const RoomId room : {5, 6}) {
      const auto at = bytes.find(room);
      const Bytes of_room = at == bytes.end() ? Bytes{} : at->second;
      std::printf("%5llu %5lld %6d %12lld %12lld %10lld %18zu\n",
                  static_cast<unsigned long long>(seed), static_cast<long long>(room), of_room.asrs,
                  static_cast<long long>(of_room.grid), static_cast<long long>(of_room.vertices),
                  static_cast<long long>(of_room.walls), of_room.outline_vertices);
      mean[room] += static_cast<double>(of_room.walls) / static_cast<double>(kSeeds);
    }
  }
  for (const auto& [room, bytes] : mean) {
    std::printf("room %lld: %.0f bytes on the mean (at most 100)\n", static_cast<long long>(room),
                bytes);
  }
}

}  // namespace

int main(int argc, char** argv) {
  // whole rounds of the variants, so that first and last rooms get the same readings
  const int rooms = (argc > 1 ? std::atoi(argv[1]) : 1000) / kVariants * kVariants;
  if (rooms >= 20) bench_steps(rooms);
  bench_nine_rooms();
}
