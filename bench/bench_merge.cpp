// SPDX-License-Identifier: GPL-3.0-or-later
// The union of a building's free space beside GEOS and Clipper, and the whole plan beside that.
//
//   bench_merge [ROOMS...]           default: 1000 3000 10000 30000 100000
//   bench_merge --one METHOD ROOMS   one line for the program itself
//
// Each method runs in a process of its own, so that its memory is its own.
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "merge/noisy_building.hpp"
#include "merge/other_libraries.hpp"

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

}  // namespace

int main(int argc, char** argv) {
  const UnionResult result = measured(argv[2], std::atoll(argv[3]));
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("%s %.6f s %.9f m2 %zu polygons %zu holes %.1f MB\n", argv[2], result.seconds,
              result.area_m2, result.polygons, result.holes,
              static_cast<double>(usage.ru_maxrss) / 1024.0);
  (void)argc;
}
