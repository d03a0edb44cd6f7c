// SPDX-License-Identifier: GPL-3.0-or-later
#include "wkb.hpp"

#include <array>
#include <string>

namespace roomatlas {
namespace {

enum Type : std::uint32_t {
  kLineString = 2,
  kPolygon = 3,
  kMultiLineString = 5,
  kMultiPolygon = 6,
};

constexpr std::uint8_t kLittleEndian = 1;
constexpr std::size_t kPointBytes = 16;
constexpr std::size_t kCountBytes = 4;
constexpr std::size_t kHeaderBytes = 5;  // byte order, type

void write_header(ByteWriter& out, Type type, std::size_t count) {
  out.u8(kLittleEndian);
  out.u32(type);
  out.u32(static_cast<std::uint32_t>(count));
}

void write_point(ByteWriter& out, const Point2& point) {
  out.f64(point.x());
  out.f64(point.y());
}

void write_ring(ByteWriter& out, const Ring& ring) {
  out.u32(static_cast<std::uint32_t>(ring.empty() ? 0 : ring.size() + 1));
  for (const Point2& point : ring) write_point(out, point);
  if (!ring.empty()) write_point(out, ring.front());
}

void write_line(ByteWriter& out, const Polyline& line) {
  write_header(out, kLineString, line.size());
  for (const Point2& point : line) write_point(out, point);
}

void write_polygon(ByteWriter& out, const Polygon& polygon) {
  if (polygon.outer.empty() && polygon.holes.empty()) return write_header(out, kPolygon, 0);
  write_header(out, kPolygon, 1 + polygon.holes.size());
  write_ring(out, polygon.outer);
  for (const Ring& hole : polygon.holes) write_ring(out, hole);
}

/// Checks the header and returns how many parts of at least `bytes_each` bytes follow.
std::size_t read_header(ByteReader& in, Type type, std::size_t bytes_each) {
  if (in.u8() != kLittleEndian) throw DamagedData("geometry is not little-endian WKB");
  const std::uint32_t found = in.u32();
  if (found != type) {
    throw DamagedData("geometry has WKB type " + std::to_string(found) + ", expected " +
                      std::to_string(type));
  }
  return in.counted(in.u32(), bytes_each);
}

Polyline read_points(ByteReader& in, std::size_t count) {
  Polyline points(count);
  for (Point2& point : points) {
    point.x() = in.f64();
    point.y() = in.f64();
  }
  return points;
}

Ring read_ring(ByteReader& in) {
  Ring ring = read_points(in, in.counted(in.u32(), kPointBytes));
  if (!ring.empty()) ring.pop_back();
  return ring;
}

Polyline read_line(ByteReader& in) {
  const std::size_t count = read_header(in, kLineString, kPointBytes);
  return read_points(in, count);
}

Polygon read_polygon(ByteReader& in) {
  const std::size_t rings = read_header(in, kPolygon, kCountBytes);
  Polygon polygon;
  if (rings > 0) polygon.outer = read_ring(in);
  for (std::size_t i = 1; i < rings; ++i) polygon.holes.push_back(read_ring(in));
  return polygon;
}

}  // namespace

Bytes wkb_of_line(const Polyline& line) {
  ByteWriter out;
  write_line(out, line);
  return out.take();
}

Bytes wkb_of_lines(const std::vector<Polyline>& lines) {
  ByteWriter out;
  write_header(out, kMultiLineString, lines.size());
  for (const Polyline& line : lines) write_line(out, line);
  return out.take();
}

Bytes wkb_of_polygon(const Polygon& polygon) {
  ByteWriter out;
  write_polygon(out, polygon);
  return out.take();
}

Bytes wkb_of_polygons(const std::vector<Polygon>& polygons) {
  ByteWriter out;
  write_header(out, kMultiPolygon, polygons.size());
  for (const Polygon& polygon : polygons) write_polygon(out, polygon);
  return out.take();
}

Polyline line_of_wkb(ByteView wkb) {
  ByteReader in(wkb);
  return read_line(in);
}

std::vector<Polyline> lines_of_wkb(ByteView wkb) {
  ByteReader in(wkb);
  std::vector<Polyline> lines(read_header(in, kMultiLineString, kHeaderBytes));
  for (Polyline& line : lines) line = read_line(in);
  return lines;
}

Polygon polygon_of_wkb(ByteView wkb) {
  ByteReader in(wkb);
  return read_polygon(in);
}

std::vector<Polygon> polygons_of_wkb(ByteView wkb) {
  ByteReader in(wkb);
  std::vector<Polygon> polygons(read_header(in, kMultiPolygon, kHeaderBytes));
  for (Polygon& polygon : polygons) polygon = read_polygon(in);
  return polygons;
}

Bytes geopackage_blob(const Bytes& wkb, const Box2& box, std::int32_t srs_id) {
  constexpr std::uint8_t kEnvelopeXy = 1 << 1;
  constexpr std::uint8_t kEmpty = 1 << 4;
  ByteWriter out;
  out.u8('G');
  out.u8('P');
  out.u8(0);  // version 1
  out.u8(static_cast<std::uint8_t>(kLittleEndian | (box.empty() ? kEmpty : kEnvelopeXy)));
  out.u32(static_cast<std::uint32_t>(srs_id));
  if (!box.empty()) {
    for (const double bound : {box.min.x(), box.max.x(), box.min.y(), box.max.y()}) out.f64(bound);
  }
  out.append(wkb);
  return out.take();
}

ByteView wkb_of_geopackage_blob(ByteView blob) {
  constexpr std::array<std::size_t, 5> kEnvelopeDoubles = {0, 4, 6, 6,
                                                           8};  // none, xy, xyz, xym, xyzm
  ByteReader in(blob);
  if (in.u8() != 'G' || in.u8() != 'P') throw DamagedData("geometry is no GeoPackage blob");
  in.skip(1);
  const std::size_t envelope = (in.u8() >> 1) & 7u;
  if (envelope >= kEnvelopeDoubles.size()) throw DamagedData("geometry has an unknown envelope");
  in.skip(4 + 8 * kEnvelopeDoubles[envelope]);
  return blob.last(in.remaining());
}

}  // namespace roomatlas
