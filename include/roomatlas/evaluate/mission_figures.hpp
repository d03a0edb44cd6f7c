// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "roomatlas/asr/store.hpp"
#include "roomatlas/assembly/member_mission.hpp"
#include "roomatlas/loops/closures.hpp"
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

/// What a mission has to do with a room.
struct RoomOfMission {
  RoomId room = 0;
  int visits = 0;         ///< times that the robot came in; 0: it only looked in
  double first_s = 0.0;   ///< of its visits, in the mission's own clock ...
  double last_s = 0.0;    ///< ... both 0 without visits
  double seen_m2 = 0.0;   ///< of the room's floor, inside the free space of the mission's ASRs
  double floor_m2 = 0.0;  ///< of the room; both on a lattice of 0.2 m
};

/// One of several missions of a building.
struct MissionFigures {
  std::string name;
  SensorKind sensor = SensorKind::laser;
  double path_length_m = 0.0;
  double first_s = 0.0;
  double last_s = 0.0;
  std::vector<RoomOfMission> rooms;  ///< ascending; those that it was in or saw floor of
  double seen_m2 = 0.0;              ///< of all rooms' floor
  /// Its walls against those that other missions saw in the same room and that run the same way
  /// within 0.3 m: how much was compared, and the root mean square of the distances; NaN where
  /// nothing was.
  double walls_compared_m = 0.0;
  double walls_rms_m = std::numeric_limits<double>::quiet_NaN();
};

/// Matches between the visits of two missions, and how far the poses are from what they measured.
struct MissionPair {
  std::size_t first = 0;  ///< indices of the missions, first < second
  std::size_t second = 0;
  int accepted = 0;
  int refused = 0;                                          ///< by any verdict
  double rms_m = std::numeric_limits<double>::quiet_NaN();  ///< of the accepted ones
  double rms_deg = std::numeric_limits<double>::quiet_NaN();
};

struct MissionsFigures {
  double floor_m2 = 0.0;                 ///< of all rooms, on the same lattice as what was seen
  std::vector<MissionFigures> missions;  ///< in the order of the members
  std::vector<MissionPair> pairs;        ///< that any match was tried of
};

/// Who saw which room when, how much of the building, and how well the missions agree.
/// @param source the building's ASRs; paths and geometry are loaded, one ASR at a time
/// @param placement of all of them, building_from_asr
/// @param closures of the building; those within one mission are left out
[[nodiscard]] MissionsFigures mission_figures(const AsrSource& source, const Placement& placement,
                                              const std::vector<MemberMission>& members,
                                              const std::vector<Closure>& closures,
                                              const FloorPlan& plan);

}  // namespace roomatlas
