// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/asr/store.hpp"

namespace roomatlas {

/// ASRs in memory. Hands out no more of each than is asked for.
class MemoryStore : public AsrSink, public AsrSource {
 public:
  void put(const Asr& asr) override { asrs.push_back(asr); }
  void put(const TruePose& truth) override { true_poses.push_back(truth); }

  [[nodiscard]] std::vector<AsrId> ids() const override;
  [[nodiscard]] Asr get(AsrId id, AsrDetail detail) const override;
  [[nodiscard]] std::vector<TruePose> truth() const override { return true_poses; }

  std::vector<Asr> asrs;
  std::vector<TruePose> true_poses;
};

}  // namespace roomatlas
