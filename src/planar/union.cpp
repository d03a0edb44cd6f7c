// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/planar/millimetre_grid.hpp"
#include "roomatlas/planar/planar_map.hpp"

#include "roomatlas/planar/union.hpp"

namespace roomatlas {
namespace {

constexpr double kSquareMillimetres = 1e6;  // in a square metre

/// Polygons on one grid, in one list.
struct Gridded {
  planar::MillimetreGrid grid;
  std::vector<Polygon> shapes_mm;
};

Gridded gridded(const std::vector<Polygon>& first, const std::vector<Polygon>& second) {
  Box2 box;
  for (const Polygon& polygon : first) planar::extend(box, polygon);
  for (const Polygon& polygon : second) planar::extend(box, polygon);
  Gridded all{planar::MillimetreGrid(box), {}};
  for (const auto* polygons : {&first, &second}) {
    for (const Polygon& polygon : *polygons) {
      all.shapes_mm.push_back(planar::on_grid(all.grid, polygon));
    }
  }
  return all;
}

}  // namespace

std::vector<Polygon> union_of(const std::vector<Polygon>& polygons) {
  const Gridded all = gridded(polygons, {});
  const planar::PlanarMap map(all.shapes_mm, all.grid.fine());
  std::vector<int> group;
  for (int region = 0; region < map.region_count(); ++region) {
    group.push_back(map.covering(region).empty() ? -1 : 0);
  }
  return all.grid.to_metres(map.trace(group, 1).front());
}

std::vector<Polygon> difference_of(const std::vector<Polygon>& first,
                                   const std::vector<Polygon>& second) {
  const Gridded all = gridded(first, second);
  const planar::PlanarMap map(all.shapes_mm, all.grid.fine());
  const int split = static_cast<int>(first.size());
  std::vector<int> group;
  for (int region = 0; region < map.region_count(); ++region) {
    const std::span<const int> over = map.covering(region);
    group.push_back(!over.empty() && over.back() < split ? 0 : -1);
  }
  return all.grid.to_metres(map.trace(group, 1).front());
}

double overlap_area(const std::vector<Polygon>& first, const std::vector<Polygon>& second) {
  const Gridded all = gridded(first, second);
  const planar::PlanarMap map(all.shapes_mm, all.grid.fine());
  double sum_mm2 = 0.0;
  for (int region = 0; region < map.region_count(); ++region) {
    const std::span<const int> over = map.covering(region);
    const int split = static_cast<int>(first.size());
    if (!over.empty() && over.front() < split && over.back() >= split) {
      sum_mm2 += map.area_mm2(region);
    }
  }
  return sum_mm2 / kSquareMillimetres;
}

}  // namespace roomatlas
