// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>

#include "roomatlas/correct/place.hpp"
#include "roomatlas/evaluate/evaluation.hpp"
#include "roomatlas/loops/visit_graph.hpp"
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

/// What the report page shows, as one JSON object: the summary, and the geometry in building
/// metres, rounded to 1 mm. The path is thinned to a point for each 0.1 m.
/// @param metadata of the store
/// @param date of the mission; may be empty
[[nodiscard]] std::string report_data(const std::map<std::string, std::string>& metadata,
                                      const std::string& date, const Correction& correction,
                                      const FloorPlan& plan, const RoomGraph& graph,
                                      const PlacedMission& placed,
                                      const VisitUncertainty& uncertainty,
                                      const std::optional<Evaluation>& evaluation);

}  // namespace roomatlas
