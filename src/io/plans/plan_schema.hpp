// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/plan/floor_plan.hpp"

#include <array>

namespace roomatlas::plan_schema {

// The words of plan.local.geojson, shared by its writer and its reader (docs/formats.md).

constexpr const char* kSchema = "plan";
constexpr int kVersion = 1;  ///< of the layout; readers refuse others
constexpr const char* kUnits = "m";
constexpr const char* kFrame = "local building metres, not longitude/latitude";

struct RoomWord {
  RoomKind kind;
  const char* word;    ///< of `kind`
  const char* indoor;  ///< of OpenStreetMap's Simple Indoor Tagging
};

constexpr std::array<RoomWord, 3> kRoomWords = {{
    {RoomKind::room, "room", "room"},
    {RoomKind::corridor, "corridor", "corridor"},
    {RoomKind::hall, "hall", "area"},
}};

}  // namespace roomatlas::plan_schema
