// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "files/bytes.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/correct/correction.hpp"
#include "roomatlas/loops/closures.hpp"
#include "roomatlas/plan/floor_plan.hpp"

#include <array>
#include <string>
#include <utility>

namespace roomatlas {

/// The words that the store's tables use for enumerations. They belong to the file format: what
/// a person is shown may change, these may not.
template <typename Enum, std::size_t N>
using StoredNames = std::array<std::pair<Enum, const char*>, N>;

inline constexpr StoredNames<SensorKind, 2> kSensorKinds = {
    {{SensorKind::laser, "laser"}, {SensorKind::sonar, "sonar"}}};
inline constexpr StoredNames<PassageKind, 2> kPassageKinds = {
    {{PassageKind::doorway, "doorway"}, {PassageKind::open_passage, "open_passage"}}};
inline constexpr StoredNames<RoomKind, 3> kRoomKinds = {
    {{RoomKind::room, "room"}, {RoomKind::corridor, "corridor"}, {RoomKind::hall, "hall"}}};
inline constexpr StoredNames<DoorKind, 3> kDoorKinds = {
    {{DoorKind::door, "door"}, {DoorKind::passage, "passage"}, {DoorKind::window, "window"}}};
inline constexpr StoredNames<WallEvidence, 3> kWallEvidences = {
    {{WallEvidence::measured, "measured"},
     {WallEvidence::inferred, "inferred"},
     {WallEvidence::unexplored, "unexplored"}}};
inline constexpr StoredNames<FurnitureKind, 2> kFurnitureKinds = {
    {{FurnitureKind::against_wall, "against_wall"},
     {FurnitureKind::free_standing, "free_standing"}}};
inline constexpr StoredNames<FactorKind, 4> kFactorKinds = {
    {{FactorKind::odometry, "odometry"},
     {FactorKind::doorway, "doorway"},
     {FactorKind::closure, "closure"},
     {FactorKind::wall_direction, "wall_direction"}}};
inline constexpr StoredNames<ClosureVerdict, 4> kClosureVerdicts = {
    {{ClosureVerdict::accepted, "accepted"},
     {ClosureVerdict::too_little_in_common, "too little in common"},
     {ClosureVerdict::contradicted, "contradicted by readings"},
     {ClosureVerdict::left_out, "left out as asked"}}};
inline constexpr StoredNames<Severity, 3> kSeverities = {
    {{Severity::note, "note"}, {Severity::warning, "warning"}, {Severity::error, "error"}}};

template <typename Enum, std::size_t N>
[[nodiscard]] const char* stored_name(const StoredNames<Enum, N>& names, Enum value) {
  for (const auto& [candidate, name] : names) {
    if (candidate == value) return name;
  }
  throw std::logic_error("the store has no name for this kind");
}

/// Throws DamagedData for a word that the format does not have.
template <typename Enum, std::size_t N>
[[nodiscard]] Enum value_of_stored_name(const StoredNames<Enum, N>& names,
                                        const std::string& text) {
  for (const auto& [value, name] : names) {
    if (text == name) return value;
  }
  throw DamagedData("unknown kind '" + text + "'");
}

}  // namespace roomatlas
