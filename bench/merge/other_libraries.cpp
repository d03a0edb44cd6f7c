// SPDX-License-Identifier: GPL-3.0-or-later
#include "merge/other_libraries.hpp"

#include <geos_c.h>

#include <cmath>
#include <ctime>
#include <memory>
#include <polyclipping/clipper.hpp>
#include <stdexcept>

namespace roomatlas::bench {
namespace {

constexpr double kMillimetres = 1000.0;
constexpr double kSquareMillimetres = 1e6;

using Context = std::remove_pointer_t<GEOSContextHandle_t>;

/// One context and what hangs on it. Geometries are millimetres.
class Geos {
 public:
  Geos() : context_(GEOS_init_r(), GEOS_finish_r) {}

  [[nodiscard]] GEOSContextHandle_t get() const { return context_.get(); }

  [[nodiscard]] GEOSGeometry* ring(const Ring& ring_m) const {
    const auto count = static_cast<unsigned>(ring_m.size());
    GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(get(), count + 1, 2);
    for (unsigned i = 0; i <= count; ++i) {
      const Point2& point = ring_m[i % count];
      GEOSCoordSeq_setXY_r(get(), sequence, i, std::round(point.x() * kMillimetres),
                           std::round(point.y() * kMillimetres));
    }
    return GEOSGeom_createLinearRing_r(get(), sequence);
  }

  [[nodiscard]] GEOSGeometry* polygon(const Polygon& polygon_m) const {
    std::vector<GEOSGeometry*> holes;
    for (const Ring& hole : polygon_m.holes) holes.push_back(ring(hole));
    GEOSGeometry* polygon = GEOSGeom_createPolygon_r(get(), ring(polygon_m.outer), holes.data(),
                                                     static_cast<unsigned>(holes.size()));
    if (GEOSisValid_r(get(), polygon) != 1) throw std::runtime_error("a polygon is not valid");
    return polygon;
  }

 private:
  std::unique_ptr<Context, decltype(&GEOS_finish_r)> context_;
};

void add(ClipperLib::Clipper& clipper, Ring ring_m, bool counter_clockwise) {
  if ((signed_area(ring_m) > 0.0) != counter_clockwise) ring_m = {ring_m.rbegin(), ring_m.rend()};
  ClipperLib::Path path;
  for (const Point2& point : ring_m) {
    path.emplace_back(std::llround(point.x() * kMillimetres),
                      std::llround(point.y() * kMillimetres));
  }
  clipper.AddPath(path, ClipperLib::ptSubject, true);
}

}  // namespace

double processor_s() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

UnionResult union_by_geos(const std::vector<Polygon>& polygons_m) {
  const Geos geos;
  std::vector<GEOSGeometry*> polygons;
  for (const Polygon& polygon : polygons_m) polygons.push_back(geos.polygon(polygon));
  GEOSGeometry* all = GEOSGeom_createCollection_r(
      geos.get(), GEOS_GEOMETRYCOLLECTION, polygons.data(), static_cast<unsigned>(polygons.size()));
  UnionResult result;
  const double start_s = processor_s();
  GEOSGeometry* united = GEOSUnaryUnion_r(geos.get(), all);
  result.seconds = processor_s() - start_s;
  if (united == nullptr) throw std::runtime_error("GEOS failed");
  GEOSArea_r(geos.get(), united, &result.area_m2);
  result.area_m2 /= kSquareMillimetres;
  result.polygons = static_cast<std::size_t>(GEOSGetNumGeometries_r(geos.get(), united));
  for (int i = 0; i < static_cast<int>(result.polygons); ++i) {
    const GEOSGeometry* part = GEOSGetGeometryN_r(geos.get(), united, i);
    result.holes += static_cast<std::size_t>(GEOSGetNumInteriorRings_r(geos.get(), part));
  }
  GEOSGeom_destroy_r(geos.get(), united);
  GEOSGeom_destroy_r(geos.get(), all);
  return result;
}

UnionResult union_by_clipper(const std::vector<Polygon>& polygons_m) {
  ClipperLib::Clipper clipper;
  for (const Polygon& polygon : polygons_m) {
    add(clipper, polygon.outer, true);
    for (const Ring& hole : polygon.holes) add(clipper, hole, false);
  }
  UnionResult result;
  ClipperLib::Paths rings;
  const double start_s = processor_s();
  clipper.Execute(ClipperLib::ctUnion, rings, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  result.seconds = processor_s() - start_s;
  for (const ClipperLib::Path& ring : rings) {
    const double area_mm2 = ClipperLib::Area(ring);
    result.area_m2 += area_mm2 / kSquareMillimetres;
    ++(area_mm2 > 0.0 ? result.polygons : result.holes);
  }
  return result;
}

}  // namespace roomatlas::bench
