// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

/// The plan as a building of Open-RMF's traffic editor (`building.yaml`, coordinate system
/// `cartesian_meters`: building metres, y up), one level: vertices, walls, doors, floors, and the
/// lanes of `route_graph_of`, driven both ways. docs/formats.md says what stands for what.
[[nodiscard]] std::string rmf_building_yaml(const FloorPlan& plan);

}  // namespace roomatlas
