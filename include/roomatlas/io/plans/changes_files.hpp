// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "roomatlas/plan/change.hpp"

namespace roomatlas {

/// The changes as GeoJSON in old building's metres: a feature for each outline that is gone or new,
/// each room that one mission alone entered, and each piece of floor that was not seen again.
[[nodiscard]] std::string changes_geojson(const PlanChanges& changes);

/// The changes as a table, RFC 4180 with a header line, one change or one-sided room a line.
[[nodiscard]] std::string changes_csv(const PlanChanges& changes);

/// One JSON object on one line, for `compare --json`.
[[nodiscard]] std::string changes_json(const PlanChanges& changes);

/// What is said of a room: "room not visited again", or "room first visited".
[[nodiscard]] const char* to_string(const OneSidedRoom& room);

}  // namespace roomatlas
