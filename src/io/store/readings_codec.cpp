// SPDX-License-Identifier: GPL-3.0-or-later
#include "readings_codec.hpp"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomatlas {
namespace {

// What is no positive number; negative millimetres follow below.
constexpr std::int64_t kNan = 0;
constexpr std::int64_t kPlusInfinity = -1;
constexpr std::int64_t kMinusInfinity = -2;
constexpr std::int64_t kZero = -3;
constexpr double kLargest_mm = 1e12;

float metres(std::int64_t code) {
  switch (code) {
    case kNan:
      return std::numeric_limits<float>::quiet_NaN();
    case kPlusInfinity:
      return std::numeric_limits<float>::infinity();
    case kMinusInfinity:
      return -std::numeric_limits<float>::infinity();
    default:
      return static_cast<float>(static_cast<double>(code > 0 ? code : code - kZero) / 1e3);
  }
}

std::int64_t rounded_mm(double range_m) {
  return std::llround(std::min(range_m * 1e3, kLargest_mm));
}

/// Millimetres on the same side of the sensor's maximum as the range itself.
std::int64_t code_of_positive(float range_m, double max_range_m) {
  const std::int64_t mm = std::max<std::int64_t>(1, rounded_mm(range_m));
  const bool is_echo = range_m < max_range_m;
  if (is_echo == (metres(mm) < max_range_m)) return mm;
  return is_echo ? std::max<std::int64_t>(1, mm - 1) : mm + 1;
}

std::int64_t code_of(float range_m, double max_range_m) {
  if (std::isnan(range_m)) return kNan;
  if (std::isinf(range_m)) return range_m > 0 ? kPlusInfinity : kMinusInfinity;
  if (range_m > 0) return code_of_positive(range_m, max_range_m);
  return range_m < 0 ? kZero - std::max<std::int64_t>(1, rounded_mm(-range_m)) : kZero;
}

bool stamps_follow_path(const Asr& asr) {
  return std::equal(asr.readings.begin(), asr.readings.end(), asr.path.begin(), asr.path.end(),
                    [](const RangeReading& reading, const PathSample& sample) {
                      return reading.timestamp_s == sample.timestamp_s &&
                             reading.odom_from_robot == sample.odom_from_robot;
                    });
}

void write_stamp(ByteWriter& out, const RangeReading& reading) {
  const Pose2& pose = reading.odom_from_robot;
  for (const double value : {reading.timestamp_s, pose.x_m, pose.y_m, pose.theta_rad}) {
    out.f64(value);
  }
}

void read_stamp(ByteReader& in, RangeReading& reading) {
  Pose2& pose = reading.odom_from_robot;
  for (double* value : {&reading.timestamp_s, &pose.x_m, &pose.y_m, &pose.theta_rad}) {
    *value = in.f64();
  }
}

void write_ranges(ByteWriter& out, const RangeReading& reading) {
  out.varint(reading.ranges_m.size());
  std::int64_t previous = 0;
  for (const float range_m : reading.ranges_m) {
    const std::int64_t code = code_of(range_m, reading.sensor->max_range_m);
    out.zigzag(code - previous);
    previous = code;
  }
}

void read_ranges(ByteReader& in, RangeReading& reading) {
  reading.ranges_m.resize(in.counted(in.varint(), 1));
  std::uint64_t code = 0;  // unsigned: damaged data must not overflow
  for (float& range_m : reading.ranges_m) {
    code += static_cast<std::uint64_t>(in.zigzag());
    range_m = metres(static_cast<std::int64_t>(code));
  }
}

Bytes deflated(const Bytes& raw) {
  uLongf size = compressBound(static_cast<uLong>(raw.size()));
  Bytes packed(size);
  if (compress2(packed.data(), &size, raw.data(), static_cast<uLong>(raw.size()), 9) != Z_OK) {
    throw std::runtime_error("zlib cannot compress the readings: out of memory");
  }
  packed.resize(size);
  return packed;
}

Bytes inflated(const PackedReadings& packed) {
  constexpr std::int64_t kMostExpansion = 1100;  // of the deflate format: 1032
  const auto packed_bytes = static_cast<std::int64_t>(packed.deflated.size());
  if (packed.raw_bytes < 1 || packed.raw_bytes > kMostExpansion * packed_bytes) {
    throw DamagedData("the readings' size is damaged");
  }
  Bytes raw(static_cast<std::size_t>(packed.raw_bytes));
  uLongf size = static_cast<uLongf>(raw.size());
  const int status = uncompress(raw.data(), &size, packed.deflated.data(),
                                static_cast<uLong>(packed.deflated.size()));
  if (status != Z_OK || size != raw.size()) throw DamagedData("the readings are damaged");
  return raw;
}

}  // namespace

PackedReadings pack_readings(const Asr& asr, const SensorIdOf& sensor_id_of) {
  const bool own_stamps = !stamps_follow_path(asr);
  ByteWriter out;
  out.u8(own_stamps ? 1 : 0);
  for (const RangeReading& reading : asr.readings) {
    out.varint(static_cast<std::uint64_t>(sensor_id_of(reading.sensor)));
    write_ranges(out, reading);
    if (own_stamps) write_stamp(out, reading);
  }
  const Bytes raw = out.take();
  return {static_cast<std::int64_t>(asr.readings.size()), static_cast<std::int64_t>(raw.size()),
          deflated(raw)};
}

std::vector<RangeReading> unpack_readings(const PackedReadings& packed,
                                          const std::vector<PathSample>& path,
                                          const SensorOf& sensor_of) {
  const Bytes raw = inflated(packed);
  ByteReader in(raw);
  const bool own_stamps = in.u8() != 0;
  std::vector<RangeReading> readings(in.counted(static_cast<std::uint64_t>(packed.count), 2));
  if (!own_stamps && readings.size() != path.size()) {
    throw DamagedData("the readings do not match the path");
  }
  for (std::size_t i = 0; i < readings.size(); ++i) {
    readings[i].sensor = sensor_of(static_cast<std::int64_t>(in.varint()));
    read_ranges(in, readings[i]);
    if (own_stamps) {
      read_stamp(in, readings[i]);
    } else {
      readings[i].timestamp_s = path[i].timestamp_s;
      readings[i].odom_from_robot = path[i].odom_from_robot;
    }
  }
  return readings;
}

}  // namespace roomatlas
