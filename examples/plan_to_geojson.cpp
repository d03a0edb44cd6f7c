// SPDX-License-Identifier: GPL-3.0-or-later
// The plan in a store that `roomatlas build` has left, as GeoJSON in longitude and latitude:
//
//     plan_to_geojson building.gpkg 49.0134 8.4044 15 plan.geojson
#include <exception>
#include <iostream>
#include <roomatlas/io/files/files.hpp>
#include <roomatlas/io/plans/georeference.hpp>
#include <roomatlas/io/store/geopackage_store.hpp>

int main(int argc, char** argv) try {
  using namespace roomatlas;
  if (argc != 6) {
    throw UsageError("usage: plan_to_geojson STORE LATITUDE LONGITUDE HEADING PLAN.geojson");
  }
  const GeoPackageStore store(argv[1], GeoPackageStore::Mode::read);
  const FloorPlan plan = store.plan();

  // Where the plan's origin lies on the earth, and which way its y axis points there.
  const GeoReference origin{std::stod(argv[2]), std::stod(argv[3]), std::stod(argv[4])};
  write_file(argv[5], to_geojson(plan, origin));

  std::cout.precision(9);
  for (const PlanRoom& room : plan.rooms) {
    const GeoPosition at = position_on_earth(origin, room.label_point);
    std::cout << "room " << room.name << " is at " << at.latitude_deg << ", " << at.longitude_deg
              << '\n';
  }
  return 0;
} catch (const std::exception& error) {
  std::cerr << "plan_to_geojson: " << error.what() << '\n';
  return 1;
}
