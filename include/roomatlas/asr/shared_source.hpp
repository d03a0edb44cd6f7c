// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>

#include "roomatlas/asr/load.hpp"

namespace roomatlas {

/// A source that several threads ask: one at a time, since sources need not stand more.
class SharedSource {
 public:
  explicit SharedSource(const AsrSource& source) : source_(source) {}

  [[nodiscard]] Asr get(AsrId id, AsrDetail detail) const {
    const std::lock_guard lock(mutex_);
    return source_.get(id, detail);
  }
  /// See the function of this name.
  [[nodiscard]] Asr load_with_readings(AsrId id) const {
    const std::lock_guard lock(mutex_);
    return roomatlas::load_with_readings(source_, id);
  }

 private:
  const AsrSource& source_;
  mutable std::mutex mutex_;
};

}  // namespace roomatlas
