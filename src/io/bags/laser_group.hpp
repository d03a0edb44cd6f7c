// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/messages.hpp"

#include "roomatlas/mission/mission.hpp"

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace roomatlas::io {

/// Several lasers of one robot that are one reading: the first one's sweeps, each with that of
/// every other laser that is nearest in time.
class LaserGroup {
 public:
  struct Sweep {
    std::int64_t stamp_ns = 0;
    std::int64_t until_ns = 0;
    LaserScanMessage scan;
  };
  LaserGroup() = default;
  /// @param others topics of the lasers after the first
  /// @param near_ns a sweep that is farther off in time is none of the reading's
  LaserGroup(const std::vector<std::size_t>& others, std::int64_t near_ns);

  [[nodiscard]] bool has(std::size_t topic) const { return others_.contains(topic); }
  [[nodiscard]] bool empty() const { return others_.empty(); }
  void add(std::size_t topic, Sweep sweep);
  /// The topics of the others, in their order.
  [[nodiscard]] const std::vector<std::size_t>& topics() const { return topics_; }
  /// Whether all that may come of a laser about that time is there.
  [[nodiscard]] bool is_there(std::size_t topic, std::int64_t stamp_ns) const;
  /// The nearest one; null where none is near. Valid until the next call of another.
  [[nodiscard]] const Sweep* nearest(std::size_t topic, std::int64_t stamp_ns) const;
  /// Forgets what is of no use to a reading after that time.
  void forget_before(std::size_t topic, std::int64_t stamp_ns, const Sweep* used);

  /// One reading of all, with the first one's time and pose. A laser without a sweep, of which the
  /// sensor is known from earlier, has no ranges in it.
  /// @param parts as many as lasers; the first is there
  [[nodiscard]] RangeReading joined(const std::vector<std::optional<RangeReading>>& parts);

  [[nodiscard]] std::int64_t left_out() const { return left_out_; }
  [[nodiscard]] std::int64_t missing() const { return missing_; }

 private:
  using Sensors = std::vector<std::shared_ptr<const RangeSensor>>;
  [[nodiscard]] std::shared_ptr<const RangeSensor> sensor_of(const Sensors& sensors);

  std::vector<std::size_t> topics_;
  std::map<std::size_t, std::deque<Sweep>> others_;  ///< by topic; sweeps by stamp
  std::int64_t near_ns_ = 0;
  Sensors last_;  ///< of each laser
  std::map<Sensors, std::shared_ptr<const RangeSensor>> joined_;
  std::int64_t left_out_ = 0;
  std::int64_t missing_ = 0;
};

}  // namespace roomatlas::io
