// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <vector>

#include "roomatlas/asr/store.hpp"

namespace roomatlas {

/// The ASRs of several missions as one source. Those of each mission keep their order and get the
/// numbers that follow the mission before. The sources must outlive it.
class JoinedSource : public AsrSource {
 public:
  explicit JoinedSource(const std::vector<const AsrSource*>& sources);

  [[nodiscard]] std::vector<AsrId> ids() const override;
  [[nodiscard]] Asr get(AsrId id, AsrDetail detail) const override;
  /// Of one mission after the other: their times are not each other's.
  [[nodiscard]] std::vector<TruePose> truth() const override;

  /// What is added to the numbers of a source's ASRs.
  [[nodiscard]] AsrId offset(std::size_t source) const { return parts_.at(source).offset; }

 private:
  struct Part {
    const AsrSource* source = nullptr;
    AsrId offset = 0;
    AsrId last = 0;
  };
  std::vector<Part> parts_;
};

/// A source without some of its ASRs.
class SelectedAsrs : public AsrSource {
 public:
  SelectedAsrs(const AsrSource& source, std::vector<AsrId> ids)
      : source_(source), ids_(std::move(ids)) {}

  [[nodiscard]] std::vector<AsrId> ids() const override { return ids_; }
  [[nodiscard]] Asr get(AsrId id, AsrDetail detail) const override {
    return source_.get(id, detail);
  }
  [[nodiscard]] std::vector<TruePose> truth() const override { return source_.truth(); }

 private:
  const AsrSource& source_;
  std::vector<AsrId> ids_;
};

/// All but some; `source` must outlive it.
[[nodiscard]] SelectedAsrs without(const AsrSource& source, const std::set<AsrId>& some);

}  // namespace roomatlas
