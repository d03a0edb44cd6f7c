// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/asr/store.hpp"

namespace roomatlas {

/// A source in which the paths that are given stand instead of its own. Both must outlive it.
class WithPaths : public AsrSource {
 public:
  WithPaths(const AsrSource& source, const Paths& paths) : source_(source), paths_(paths) {}

  [[nodiscard]] std::vector<AsrId> ids() const override { return source_.ids(); }
  [[nodiscard]] Asr get(AsrId id, AsrDetail detail) const override;
  [[nodiscard]] std::vector<TruePose> truth() const override { return source_.truth(); }

 private:
  const AsrSource& source_;
  const Paths& paths_;
};

}  // namespace roomatlas
