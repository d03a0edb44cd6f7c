// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "roomatlas/asr/asr.hpp"

namespace roomatlas {

/// Where the online stage puts what it has finished.
class AsrSink {
 public:
  virtual ~AsrSink() = default;
  /// Takes one whole ASR, durably: after it returns, a crash cannot lose it.
  virtual void put(const Asr& asr) = 0;
  /// Ground truth on its way to the evaluation; made durable with the next ASR.
  virtual void put(const TruePose& truth) = 0;
};

enum class AsrDetail {
  geometry,  ///< frame, walls, outline, exits, counters
  path,      ///< and the path
  readings,  ///< and the readings
};

/// Paths in the frames of their ASRs, one pose a reading.
using Paths = std::map<AsrId, std::vector<Pose2>>;

using Placement = std::map<AsrId, Pose2>;  ///< building_from_asr of each ASR

/// Where the offline stage reads from. No call reads more of the building than it names.
class AsrSource {
 public:
  virtual ~AsrSource() = default;
  [[nodiscard]] virtual std::vector<AsrId> ids() const = 0;
  /// Throws InputError when there is no such ASR.
  [[nodiscard]] virtual Asr get(AsrId id, AsrDetail detail) const = 0;
  [[nodiscard]] virtual std::vector<TruePose> truth() const = 0;
};

}  // namespace roomatlas
