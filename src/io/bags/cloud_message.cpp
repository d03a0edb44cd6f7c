// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/messages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace roomatlas::io {
namespace {

// Numbers of sensor_msgs/PointField for what coordinates and times are.
constexpr int kInt32 = 5;
constexpr int kUint32 = 6;
constexpr int kFloat32 = 7;
constexpr int kFloat64 = 8;

/// Where one number stands in a point.
struct PointField {
  std::uint32_t offset = 0;
  int datatype = 0;  ///< 0: there is none

  [[nodiscard]] std::size_t size() const { return datatype == kFloat64 ? 8 : 4; }
  [[nodiscard]] bool is_float() const { return datatype == kFloat32 || datatype == kFloat64; }
  [[nodiscard]] bool is_number() const {
    return is_float() || datatype == kInt32 || datatype == kUint32;
  }
  [[nodiscard]] bool fits(std::size_t point_bytes) const {
    return is_number() && offset + size() <= point_bytes;
  }
};

struct PointFields {
  std::array<PointField, 3> xyz;
  PointField time;
};

/// As drivers name it: Velodyne's, Ouster's, Hesai's and RoboSense's, Livox's.
bool is_time(const std::string& name) {
  static constexpr std::array kNames = {"time", "t", "timestamp", "offset_time"};
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

PointFields read_fields(MessageCursor& in) {
  constexpr std::size_t kLeastBytes = 13;
  PointFields found;
  const std::size_t fields = in.count(kLeastBytes);
  for (std::size_t i = 0; i < fields; ++i) {
    const std::string name = in.text();
    PointField field;
    field.offset = in.number<std::uint32_t>();
    field.datatype = in.number<std::uint8_t>();
    (void)in.number<std::uint32_t>();  // how many of them: one
    if (name == "x") found.xyz[0] = field;
    if (name == "y") found.xyz[1] = field;
    if (name == "z") found.xyz[2] = field;
    if (is_time(name)) found.time = field;
  }
  return found;
}

float coordinate(const PointField& field, std::span<const std::byte> point, bool big_endian) {
  const std::span<const std::byte> bytes = point.subspan(field.offset, field.size());
  return field.datatype == kFloat64
             ? static_cast<float>(MessageCursor::unpacked<double>(bytes, big_endian))
             : MessageCursor::unpacked<float>(bytes, big_endian);
}

double time_in(const PointField& field, std::span<const std::byte> point, bool big_endian) {
  const std::span<const std::byte> bytes = point.subspan(field.offset, field.size());
  switch (field.datatype) {
    case kFloat64:
      return MessageCursor::unpacked<double>(bytes, big_endian);
    case kFloat32:
      return static_cast<double>(MessageCursor::unpacked<float>(bytes, big_endian));
    case kInt32:
      return static_cast<double>(MessageCursor::unpacked<std::int32_t>(bytes, big_endian));
    default:
      return static_cast<double>(MessageCursor::unpacked<std::uint32_t>(bytes, big_endian));
  }
}

/// Drivers count seconds, milli-, micro- or nanoseconds, from the stamp or from 1970: the unit is
/// that in which the points take the time of a sweep. Empty where in none they do.
std::vector<float> as_seconds(const std::vector<double>& times, std::int64_t stamp_ns) {
  constexpr double kLeastSweepS = 2e-3;
  constexpr double kLongestSweepS = 0.5;
  constexpr double kFarS = 1.0;  // beyond it they are no times from the stamp
  const bool are_sound = !times.empty() && std::all_of(times.begin(), times.end(),
                                                       [](double t) { return std::isfinite(t); });
  if (!are_sound) return {};
  const auto [first, last] = std::minmax_element(times.begin(), times.end());
  for (const double unit_s : {1.0, 1e-3, 1e-6, 1e-9}) {
    const double span_s = unit_s * (*last - *first);
    if (span_s < kLeastSweepS || span_s > kLongestSweepS) continue;
    double zero = 0.0;  // the stamp
    if (std::abs(unit_s * *first) > kFarS) {
      zero = static_cast<double>(stamp_ns) * 1e-9 / unit_s;
      if (std::abs(unit_s * (*first - zero)) > kFarS) zero = *first;  // of another clock
    }
    std::vector<float> seconds;
    for (const double time : times) seconds.push_back(static_cast<float>(unit_s * (time - zero)));
    return seconds;
  }
  return {};
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
  const PointFields fields = read_fields(in);
  const bool big_endian = in.number<std::uint8_t>() != 0;
  const std::size_t point_bytes = in.number<std::uint32_t>();
  const std::size_t row_bytes = in.number<std::uint32_t>();
  const std::span<const std::byte> data = in.take(in.count(1));
  if (in.failed()) return std::nullopt;
  for (const PointField& field : fields.xyz) {
    cloud.has_coordinates = cloud.has_coordinates && field.is_float() && field.fits(point_bytes);
  }
  if (!cloud.has_coordinates || cloud.width == 0) return cloud;
  if (std::size_t{cloud.width} * point_bytes > row_bytes ||
      std::size_t{cloud.height} * row_bytes > data.size()) {
    return std::nullopt;
  }
  const bool has_times = fields.time.fits(point_bytes);
  std::vector<double> times;
  for (std::size_t row = 0; row < cloud.height; ++row) {
    for (std::size_t i = 0; i < cloud.width; ++i) {
      const auto bytes = data.subspan(row * row_bytes + i * point_bytes, point_bytes);
      const Eigen::Vector3f point(coordinate(fields.xyz[0], bytes, big_endian),
                                  coordinate(fields.xyz[1], bytes, big_endian),
                                  coordinate(fields.xyz[2], bytes, big_endian));
      if (!point.allFinite()) continue;
      cloud.points.push_back(point);
      if (has_times) times.push_back(time_in(fields.time, bytes, big_endian));
    }
  }
  cloud.times_s = as_seconds(times, cloud.header.stamp_ns);
  return cloud;
}

}  // namespace roomatlas::io
