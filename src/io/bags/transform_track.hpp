// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/transform3.hpp"

#include <cstdint>
#include <deque>
#include <optional>

namespace roomatlas::io {

/// What a track knows about a time.
struct TransformAt {
  Transform3 transform;
  /// How far the time is beyond what is known; 0: between two samples, or at one.
  std::int64_t beyond_ns = 0;
};

/// One transform as it changes: its samples of the last seconds, by their stamps. Samples may come
/// out of order. One that is older than all that is kept begins a new epoch: the clock was set
/// back. So does one that is late by more than `kLate_ns` at a time of which others tell already,
/// and tell otherwise: what one program publishes keeps its order.
class TransformTrack {
 public:
  static constexpr std::int64_t kKept_ns = 10'000'000'000;  ///< as tf keeps them
  static constexpr std::int64_t kLate_ns = 500'000'000;
  static constexpr std::size_t kMost = 20'000;  ///< samples

  enum class Added { in_order, out_of_order, again, clock_set_back };
  Added add(std::int64_t stamp_ns, const Transform3& sample);
  /// Interpolated; beyond the samples the nearest one. Nothing when there is none.
  [[nodiscard]] std::optional<TransformAt> at(std::int64_t stamp_ns) const;
  /// All samples of this epoch were the same: it may be a fixed mount that is published for ever.
  [[nodiscard]] bool is_constant() const { return constant_; }
  [[nodiscard]] bool empty() const { return samples_.empty(); }

 private:
  struct Sample {
    std::int64_t stamp_ns = 0;
    Transform3 transform;
  };
  [[nodiscard]] bool is_set_back(std::int64_t stamp_ns, const Transform3& sample) const;

  std::deque<Sample> samples_;  ///< by stamp
  bool constant_ = true;
};

}  // namespace roomatlas::io
