// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "roomatlas/asr/store.hpp"
#include "roomatlas/core/issue.hpp"

namespace roomatlas::test {

/// A store that keeps what it is given, and hands out no more of it than was asked for.
class MemoryStore : public AsrSink, public AsrSource {
 public:
  void put(const Asr& asr) override { asrs.push_back(asr); }
  void put(const TruePose& truth) override { true_poses.push_back(truth); }

  [[nodiscard]] std::vector<AsrId> ids() const override {
    std::vector<AsrId> found;
    for (const Asr& asr : asrs) found.push_back(asr.id);
    std::sort(found.begin(), found.end());
    return found;
  }
  [[nodiscard]] Asr get(AsrId id, AsrDetail detail) const override {
    const auto found =
        std::find_if(asrs.begin(), asrs.end(), [&](const Asr& asr) { return asr.id == id; });
    if (found == asrs.end()) throw InputError("no such ASR");
    Asr asr = *found;
    if (detail == AsrDetail::geometry) asr.path.clear();
    if (detail != AsrDetail::readings) asr.readings.clear();
    return asr;
  }
  [[nodiscard]] std::vector<AsrId> neighbors(AsrId id) const override {
    std::vector<AsrId> found;
    for (const Exit& exit : get(id, AsrDetail::geometry).exits) {
      if (exit.neighbor) found.push_back(*exit.neighbor);
    }
    std::sort(found.begin(), found.end());
    return found;
  }
  [[nodiscard]] std::vector<TruePose> truth() const override { return true_poses; }

  std::vector<Asr> asrs;
  std::vector<TruePose> true_poses;
};

}  // namespace roomatlas::test
