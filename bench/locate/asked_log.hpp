// SPDX-License-Identifier: GPL-3.0-or-later
// A log that was read once, for many pieces of it.
#pragma once

#include <filesystem>
#include <vector>

#include "roomatlas/asr/memory_store.hpp"
#include "roomatlas/mission/mission.hpp"
#include "roomatlas/pipeline/options.hpp"

namespace roomatlas::bench {

/// Times at which a piece of path begins and ends, as in the log.
struct TimeRange {
  double from_s = 0.0;
  double to_s = 0.0;
};

class AskedLog {
 public:
  /// @throws InputError where it cannot be read
  explicit AskedLog(const std::filesystem::path& file);

  /// What the online stage makes of the readings of a piece.
  /// @throws NotEnoughError where they see no wall
  [[nodiscard]] MemoryStore mapped(const TimeRange& range, const MapOptions& options) const;
  [[nodiscard]] const RobotFootprint& footprint() const { return info_.footprint; }

 private:
  MissionInfo info_;
  std::vector<RangeReading> readings_;  ///< in the order of the log
};

}  // namespace roomatlas::bench
