// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "files/bytes.hpp"
#include "roomatlas/asr/asr.hpp"

#include <functional>

namespace roomatlas {

/// All readings of one ASR, compressed.
struct PackedReadings {
  std::int64_t count = 0;      ///< readings
  std::int64_t raw_bytes = 0;  ///< before compression
  Bytes deflated;              ///< zlib stream (RFC 1950)
};

using SensorIdOf = std::function<std::int64_t(const std::shared_ptr<const RangeSensor>&)>;
using SensorOf = std::function<std::shared_ptr<const RangeSensor>(std::int64_t)>;

/// Packs an ASR's readings: ranges in whole millimetres, each as the difference to the beam
/// before it (see docs/formats.md). Guarantees for every range up to 10^9 m: it reads back to
/// less than 1 mm, ranges with three decimals read back exactly, an echo stays an echo, "no echo"
/// stays at or beyond the sensor's maximum, and NaN, the infinities, zero and negative values keep
/// their kind. Time stamps and poses are left out where the path has the same ones.
[[nodiscard]] PackedReadings pack_readings(const Asr& asr, const SensorIdOf& sensor_id_of);

/// The readings again. Throws DamagedData.
/// @param path the ASR's path, for the time stamps and poses
[[nodiscard]] std::vector<RangeReading> unpack_readings(const PackedReadings& packed,
                                                        const std::vector<PathSample>& path,
                                                        const SensorOf& sensor_of);

}  // namespace roomatlas
