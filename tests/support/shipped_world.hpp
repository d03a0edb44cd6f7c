// SPDX-License-Identifier: GPL-3.0-or-later
// The worlds that come with the project.
#pragma once

#include <filesystem>
#include <string>

#include "roomatlas/io/plans/plan_geojson.hpp"

namespace roomatlas::test {

inline const std::filesystem::path kWorlds =
    std::filesystem::path(ROOMATLAS_SOURCE_DIR) / "data" / "worlds";

inline FloorPlan shipped_world(const std::string& name) {
  return read_plan(kWorlds / (name + ".geojson"));
}

}  // namespace roomatlas::test
