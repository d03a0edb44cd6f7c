// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "roomatlas/mission/borrowed_mission.hpp"

namespace roomatlas {

/// Which readings of a mission, counted from 0.
struct MissionPart {
  int number = 0;  ///< from 1; 0: the whole mission
  std::int64_t first = 0;
  std::int64_t last = std::numeric_limits<std::int64_t>::max();  ///< this one included

  [[nodiscard]] bool is_whole() const { return number == 0; }
  /// What is put behind the mission's name: "#2"; nothing for the whole.
  [[nodiscard]] std::string suffix() const;
};

/// A part of a mission, as if it were one. Its file is NAME#2; its readings, times and length are
/// its own, what was said of the log's lines is of all that were read. True poses before the first
/// reading go with it. The mission must outlive it.
class PartOfMission : public BorrowedMission {
 public:
  PartOfMission(MissionSource& mission, const MissionPart& part);
  [[nodiscard]] std::optional<MissionEvent> next() override;
  [[nodiscard]] const MissionInfo& info() const override;

 private:
  [[nodiscard]] bool takes(const MissionEvent& event);

  MissionPart part_;
  std::int64_t reading_ = 0;  ///< number of the next one
  std::int64_t taken_ = 0;
  std::int64_t truths_ = 0;
  std::optional<StampedPose> first_;
  std::optional<StampedPose> last_;
  double path_m_ = 0.0;
  mutable MissionInfo info_;
};

}  // namespace roomatlas
