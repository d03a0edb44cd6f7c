// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "roomatlas/core/pose2.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas::bench {

// A map is right where these hold after the whole trajectory was laid on the truth.
constexpr double kRightPosition_m = 0.25;  // of every visit: a room put twice is wrong however many
                                           // of its visits are right
constexpr double kRightHeading_deg = 2.0;  // of every room, mean over its visits by their poses:
                                           // one of a few readings tells no direction

/// How far a store's trajectory and visits are from where the robot truly was, after a rigid
/// least-squares fit of the whole trajectory: figures, and one entry a visit in "visits".
/// @param world with the true rooms; may have none
[[nodiscard]] nlohmann::json judged_by_truth(const GeoPackageStore& store, const Trajectory& truth,
                                             const FloorPlan& world);

/// What the program itself says of the map: closures by their verdict, estimated accuracy.
[[nodiscard]] nlohmann::json own_figures(const GeoPackageStore& store);

}  // namespace roomatlas::bench
