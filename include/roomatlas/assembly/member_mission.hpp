// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "roomatlas/mission/mission.hpp"
#include "roomatlas/plan/ids.hpp"

namespace roomatlas {

/// One of the missions that a building was joined from.
struct MemberMission {
  std::string name;  ///< of its log
  SensorKind sensor = SensorKind::laser;
  AsrId first_asr = 0;           ///< its visits in the building's store ...
  AsrId last_asr = 0;            ///< ... this one included
  bool is_base = false;          ///< its frame is the building's; nothing was searched
  double score = 0.0;            ///< log likelihood of its place against one taken at random
  double runner_up_score = 0.0;  ///< of the next place that is another
  double agreement = 0.0;        ///< of what could be compared, [0, 1]
  int pieces = 0;                ///< that its path was cut into
  int pieces_fitting = 0;        ///< of these, on what the others saw
  /// How many of the building's true poses are its own: those of the missions follow each other.
  std::int64_t true_poses = 0;
};

/// The mission of that name: as its log is called, the same without its endings, or its number from
/// 1.
/// @throws UsageError where there is none, or several
[[nodiscard]] std::size_t index_of(const std::vector<MemberMission>& members,
                                   const std::string& name);

}  // namespace roomatlas
