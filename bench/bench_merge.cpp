// SPDX-License-Identifier: GPL-3.0-or-later
// The union of a building's free space beside GEOS and Clipper, and the whole plan beside that.
//
//   bench_merge [ROOMS...]           default: 1000 3000 10000 30000 100000, some minutes
//   bench_merge --one METHOD ROOMS   one line for the program itself
//
// Each method runs in a process of its own, so that its memory is its own.
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "merge/noisy_building.hpp"
#include "merge/other_libraries.hpp"
#include "roomatlas/planar/union.hpp"

namespace {

using namespace roomatlas;
using bench::UnionResult;

UnionResult of_polygons(const std::vector<Polygon>& polygons, double seconds) {
  UnionResult result{seconds, 0.0, polygons.size(), 0};
  for (const Polygon& polygon : polygons) {
    result.area_m2 += area(polygon);
    result.holes += polygon.holes.size();
  }
  return result;
}

UnionResult union_by_roomatlas(const std::vector<Polygon>& polygons) {
  const double start_s = bench::processor_s();
  const std::vector<Polygon> united = union_of(polygons);
  return of_polygons(united, bench::processor_s() - start_s);
}

UnionResult whole_plan(const bench::NoisyBuilding& building) {
  const double start_s = bench::processor_s();
  const FloorPlan plan = merge(building.outlines, building.doors, {});
  return of_polygons(plan.free_space, bench::processor_s() - start_s);
}

UnionResult measured(const std::string& method, std::int64_t rooms) {
  bench::NoisyBuilding building = bench::noisy_building(rooms);
  if (method == "plan") return whole_plan(building);
  const std::vector<Polygon> polygons = building.free_space();
  building = {};
  if (method == "geos") return bench::union_by_geos(polygons);
  if (method == "clipper") return bench::union_by_clipper(polygons);
  return union_by_roomatlas(polygons);
}

struct Measured {
  UnionResult result;
  double memory_mb = 0.0;
};

/// Runs one method in a process of its own and prints what `read` reads.
int run_one(const std::string& method, std::int64_t rooms) {
  const UnionResult result = measured(method, rooms);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("%.6f %.9f %zu %zu %.1f\n", result.seconds, result.area_m2, result.polygons,
              result.holes, static_cast<double>(usage.ru_maxrss) / 1024.0);
  return 0;
}

std::optional<Measured> read(const std::string& program, const std::string& method,
                             std::int64_t rooms) {
  const std::string command = "'" + program + "' --one " + method + " " + std::to_string(rooms);
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return std::nullopt;
  Measured one;
  const int read =
      std::fscanf(pipe, "%lf %lf %zu %zu %lf", &one.result.seconds, &one.result.area_m2,
                  &one.result.polygons, &one.result.holes, &one.memory_mb);
  if (pclose(pipe) != 0 || read != 5) return std::nullopt;
  return one;
}

/// e in time ~ rooms^e, between two sizes.
double exponent(const Measured& small, std::int64_t small_rooms, const Measured& large,
                std::int64_t large_rooms) {
  return std::log(large.result.seconds / small.result.seconds) /
         std::log(static_cast<double>(large_rooms) / static_cast<double>(small_rooms));
}

void print(std::int64_t rooms, const char* method, const Measured& one, const Measured& ours) {
  std::printf("%8lld %-14s %10.3f %9.2f %12.3f %11.1e %9zu %7zu %8.1f\n",
              static_cast<long long>(rooms), method, one.result.seconds,
              one.result.seconds / ours.result.seconds, one.result.area_m2,
              one.result.area_m2 / ours.result.area_m2 - 1.0, one.result.polygons, one.result.holes,
              one.memory_mb);
  std::fflush(stdout);
}

constexpr std::int64_t kClipperRooms = 30'000;  // it takes minutes from there on

}  // namespace

int main(int argc, char** argv) {
  if (argc == 4 && std::string(argv[1]) == "--one") return run_one(argv[2], std::atoll(argv[3]));
  std::vector<std::int64_t> sizes;
  for (int i = 1; i < argc; ++i) sizes.push_back(std::atoll(argv[i]));
  if (sizes.empty()) sizes = {1000, 3000, 10'000, 30'000, 100'000};
  std::printf("Processor seconds; times: over the union's of this project; area: over its area.\n");
  std::printf("%8s %-14s %10s %9s %12s %11s %9s %7s %8s\n", "rooms", "method", "seconds", "times",
              "m2", "area off", "polygons", "holes", "MB");
  std::vector<Measured> unions;
  for (const std::int64_t rooms : sizes) {
    const auto ours = read(argv[0], "union", rooms);
    if (!ours) return 1;
    unions.push_back(*ours);
    print(rooms, "union", *ours, *ours);
    for (const char* method : {"plan", "geos", "clipper"}) {
      if (rooms > kClipperRooms && std::string(method) == "clipper") continue;
      if (const auto other = read(argv[0], method, rooms)) print(rooms, method, *other, *ours);
    }
  }
  for (std::size_t i = 1; i < sizes.size(); ++i) {
    std::printf("growth exponent of the union from %lld to %lld rooms: %.2f\n",
                static_cast<long long>(sizes[i - 1]), static_cast<long long>(sizes[i]),
                exponent(unions[i - 1], sizes[i - 1], unions[i], sizes[i]));
  }
  if (sizes.size() > 2) {
    std::printf("growth exponent of the union from %lld to %lld rooms: %.2f\n",
                static_cast<long long>(sizes.front()), static_cast<long long>(sizes.back()),
                exponent(unions.front(), sizes.front(), unions.back(), sizes.back()));
  }
}
