// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/messages.hpp"

#include <array>
#include <utility>

namespace roomatlas::io {
namespace {

// Numbers of sensor_msgs/PointField for what coordinates are.
constexpr int kFloat32 = 7;
constexpr int kFloat64 = 8;

/// Where one coordinate stands in a point.
struct Coordinate {
  std::uint32_t offset = 0;
  int datatype = 0;  ///< 0: there is none

  [[nodiscard]] std::size_t size() const { return datatype == kFloat64 ? 8 : 4; }
  [[nodiscard]] bool fits(std::size_t point_bytes) const {
    return (datatype == kFloat32 || datatype == kFloat64) && offset + size() <= point_bytes;
  }
};
using Coordinates = std::array<Coordinate, 3>;

Coordinates read_fields(MessageCursor& in) {
  constexpr std::size_t kLeastBytes = 13;
  Coordinates coordinates;
  const std::size_t fields = in.count(kLeastBytes);
  for (std::size_t i = 0; i < fields; ++i) {
    const std::string name = in.text();
    Coordinate field;
    field.offset = in.number<std::uint32_t>();
    field.datatype = in.number<std::uint8_t>();
    (void)in.number<std::uint32_t>();  // how many of them: one
    if (name == "x") coordinates[0] = field;
    if (name == "y") coordinates[1] = field;
    if (name == "z") coordinates[2] = field;
  }
  return coordinates;
}

float coordinate(const Coordinate& field, std::span<const std::byte> point, bool big_endian) {
  const std::span<const std::byte> bytes = point.subspan(field.offset, field.size());
  return field.datatype == kFloat64
             ? static_cast<float>(MessageCursor::unpacked<double>(bytes, big_endian))
             : MessageCursor::unpacked<float>(bytes, big_endian);
}

}  // namespace

std::optional<CloudMessage> read_cloud(MessageCursor in) {
  CloudMessage cloud;
  const std::optional<HeaderMessage> header = read_header(in);
  if (!header) return std::nullopt;
  cloud.header = *header;
  if (in.is_ros1()) (void)in.number<std::uint32_t>();
  (void)in.number<std::uint32_t>();
  (void)in.number<std::uint32_t>();
  (void)in.text();
  cloud.height = in.number<std::uint32_t>();
  cloud.width = in.number<std::uint32_t>();
  const Coordinates xyz = read_fields(in);
  const bool big_endian = in.number<std::uint8_t>() != 0;
  const std::size_t point_bytes = in.number<std::uint32_t>();
  const std::size_t row_bytes = in.number<std::uint32_t>();
  const std::span<const std::byte> data = in.take(in.count(1));
  if (in.failed()) return std::nullopt;
  for (const Coordinate& field : xyz) {
    cloud.has_coordinates = cloud.has_coordinates && field.fits(point_bytes);
  }
  if (!cloud.has_coordinates || cloud.width == 0) return cloud;
  if (std::size_t{cloud.width} * point_bytes > row_bytes ||
      std::size_t{cloud.height} * row_bytes > data.size()) {
    return std::nullopt;
  }
  for (std::size_t row = 0; row < cloud.height; ++row) {
    for (std::size_t i = 0; i < cloud.width; ++i) {
      const auto bytes = data.subspan(row * row_bytes + i * point_bytes, point_bytes);
      const Eigen::Vector3f point(coordinate(xyz[0], bytes, big_endian),
                                  coordinate(xyz[1], bytes, big_endian),
                                  coordinate(xyz[2], bytes, big_endian));
      if (point.allFinite()) cloud.points.push_back(point);
    }
  }
  return cloud;
}

}  // namespace roomatlas::io
