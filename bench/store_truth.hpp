// SPDX-License-Identifier: GPL-3.0-or-later
// Where the building of a simulated mission lies in its world.
#pragma once

#include <optional>

#include "roomatlas/correct/place.hpp"
#include "roomatlas/evaluate/alignment.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/pipeline/evaluate_store.hpp"

namespace roomatlas::bench {

/// By least squares over the whole path; nothing for a store without true poses.
inline std::optional<Pose2> world_from_building(const GeoPackageStore& store) {
  const Trajectory truth = true_poses_of(store);
  if (truth.empty()) return std::nullopt;
  const PlacedMission placed = place(store, store.correction());
  return truth_from_estimate(match_poses(placed.corrected, truth, {}), Alignment::umeyama);
}

}  // namespace roomatlas::bench
