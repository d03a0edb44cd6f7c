// SPDX-License-Identifier: GPL-3.0-or-later
// The offline stage's time and memory against the number of rooms.
//
//   bench_offline [ROOMS...]    default: 100 300 1000 3000
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "roomatlas/pipeline/assemble.hpp"
#include "roomatlas/rooms/assign_rooms.hpp"
#include "roomatlas/rooms/doors.hpp"
#include "roomatlas/simulate/random_building.hpp"

namespace {

using namespace roomatlas;

/// ASRs in memory, found by their id, so that the store's speed is not measured too.
class Asrs : public AsrSink, public AsrSource {
 public:
  void put(const Asr& asr) override { asrs.push_back(asr); }
  void put(const TruePose&) override {}
  [[nodiscard]] std::vector<AsrId> ids() const override {
    std::vector<AsrId> found;
    for (const Asr& asr : asrs) found.push_back(asr.id);
    return found;
  }
  [[nodiscard]] Asr get(AsrId id, AsrDetail) const override {
    return asrs.at(static_cast<std::size_t>(id - 1));
  }
  [[nodiscard]] std::vector<TruePose> truth() const override { return {}; }

  std::vector<Asr> asrs;
};

/// Of the processor, which other programs disturb least; of all threads, of which there is one.
class Clock {
 public:
  /// Seconds since the last call.
  double lap_s() {
    const std::clock_t now = std::clock();
    const double lap = static_cast<double>(now - last_) / CLOCKS_PER_SEC;
    last_ = now;
    return lap;
  }

 private:
  std::clock_t last_ = std::clock();
};

const std::vector<std::string> kStages = {"assemble", "recognise", "correct",
                                          "rooms",    "doors",     "merge"};

struct Row {
  std::int64_t rooms = 0;
  std::vector<double> seconds;  ///< parallel to `kStages`
};

/// The whole stage, and then its parts one by one, each once, on the result.
Row measured(std::int64_t rooms) {
  RandomBuildingOptions building;
  building.rooms = rooms;
  Asrs source;
  const RandomBuildingSummary summary = random_building(building, source);
  Options all;
  all.jobs = 1;
  const AssembleOptions& options = all.assemble;
  Row row{rooms, {}};
  Clock clock;
  const Assembly assembly = assemble(source, RobotFootprint{}, all);
  row.seconds.push_back(clock.lap_s());

  const Placement placement = placement_of(assembly.correction);
  clock.lap_s();
  const auto recognised = recognise_doorways(source.asrs, placement, options.recognise);
  row.seconds.push_back(clock.lap_s());
  const Correction correction = correct(source.asrs, assembly.graph, options.correct);
  row.seconds.push_back(clock.lap_s());
  const auto room_of_asr = assign_rooms(source.asrs, assembly.graph, placement, options.rooms);
  row.seconds.push_back(clock.lap_s());
  const auto doors = doors_of(source.asrs, assembly.graph, placement, room_of_asr);
  row.seconds.push_back(clock.lap_s());
  std::vector<PlacedOutline> outlines;
  for (const Asr& asr : source.asrs) {
    outlines.push_back(
        {asr.id, room_of_asr.at(asr.id), transformed(placement.at(asr.id), asr.outline_asr)});
  }
  clock.lap_s();
  const FloorPlan plan = merge(outlines, doors, options.merge);
  row.seconds.push_back(clock.lap_s());

  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("%8lld %8lld %8zu %8zu %8zu", static_cast<long long>(rooms),
              static_cast<long long>(summary.asrs), recognised.size(), plan.rooms.size(),
              plan.doors.size());
  for (const double seconds : row.seconds) std::printf(" %10.3f", seconds);
  std::printf(" %8.1f\n", static_cast<double>(usage.ru_maxrss) / 1024.0);
  std::fflush(stdout);
  return row;
}

void print_header() {
  std::printf(
      "Processor seconds for each stage on random buildings; MB: the program's greatest so far.\n");
  std::printf("Assemble recognises and corrects several times and does all the rest once.\n\n");
  std::printf("%8s %8s %8s %8s %8s", "rooms", "ASRs", "recogn.", "found", "doors");
  for (const std::string& stage : kStages) std::printf(" %10s", stage.c_str());
  std::printf(" %8s\n", "MB");
}

/// e in time ~ rooms^e, between two sizes.
void print_exponents(const Row& small, const Row& large) {
  std::printf("growth exponent from %lld to %lld rooms:", static_cast<long long>(small.rooms),
              static_cast<long long>(large.rooms));
  const double sizes =
      std::log(static_cast<double>(large.rooms) / static_cast<double>(small.rooms));
  for (std::size_t i = 0; i < kStages.size(); ++i) {
    std::printf(" %s %.2f", kStages[i].c_str(),
                std::log(large.seconds[i] / small.seconds[i]) / sizes);
  }
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::int64_t> sizes;
  for (int i = 1; i < argc; ++i) sizes.push_back(std::atoll(argv[i]));
  if (sizes.empty()) sizes = {100, 300, 1000, 3000};
  print_header();
  std::vector<Row> rows;
  for (const std::int64_t rooms : sizes) rows.push_back(measured(rooms));
  std::printf("\n");
  for (std::size_t i = 1; i < rows.size(); ++i) print_exponents(rows[i - 1], rows[i]);
  if (rows.size() > 2) print_exponents(rows.front(), rows.back());
}
