// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/messages.hpp"

#include "roomatlas/mission/mission.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace roomatlas::io {

/// Joins single sonars, which a recording has one message each, to a ring: a round of it is a
/// reading. A sonar is told by its topic and frame. A round ends when all have spoken, or one of
/// them again; those that kept silent are no reading then.
class SonarRing {
 public:
  using Name = std::pair<std::size_t, std::string>;  ///< topic, frame

  struct Round {
    std::int64_t stamp_ns = 0;  ///< of its last message
    std::vector<float> ranges_m;
  };
  /// @param sonars in the order of the ring's beams
  explicit SonarRing(std::vector<Name> sonars);

  [[nodiscard]] const std::vector<Name>& sonars() const { return sonars_; }
  /// The round that this message ends, where it ends one.
  [[nodiscard]] std::optional<Round> add(std::size_t topic, const RangeMessage& message,
                                         std::int64_t stamp_ns);
  /// What is left when the recording ends.
  [[nodiscard]] std::optional<Round> finish();
  /// The ring, once all mounts are known: one a sonar; a frame's x axis is where it listens.
  [[nodiscard]] std::shared_ptr<const RangeSensor> make_sensor(
      const std::vector<Transform3>& base_from_sonar, const MissionOptions& options) const;
  [[nodiscard]] std::int64_t strangers() const { return strangers_; }

 private:
  [[nodiscard]] Round taken();

  std::vector<Name> sonars_;
  Round round_;
  std::vector<bool> heard_;
  double cone_rad_ = 0.0;  ///< the widest of all
  double max_range_m_ = 0.0;
  std::int64_t strangers_ = 0;  ///< messages of sonars that the recording's beginning has not
};

}  // namespace roomatlas::io
