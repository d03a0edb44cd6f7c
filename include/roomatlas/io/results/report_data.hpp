// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "roomatlas/correct/place.hpp"
#include "roomatlas/evaluate/evaluation.hpp"
#include "roomatlas/loops/closures.hpp"
#include "roomatlas/loops/visit_graph.hpp"
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

/// The path of one of several missions, before and after its correction, point for point.
struct ReportedPath {
  std::string name;
  Polyline before;  ///< building metres
  Polyline after;
};

/// All that the report page speaks of.
struct ReportSources {
  std::map<std::string, std::string> metadata;  ///< of the store
  std::string date;                             ///< of the mission; may be empty
  Correction correction;
  FloorPlan plan;
  RoomGraph graph;
  PlacedMission placed;
  std::vector<ReportedPath> missions;  ///< of several missions: instead of the one path
  VisitUncertainty uncertainty;
  std::map<AsrId, StampedPose> middles;  ///< of the visits' paths; building metres
  std::vector<Closure> closures;
  std::optional<Evaluation> evaluation;
};

/// What the report page shows, as one JSON object: the summary, and the geometry in building
/// metres, rounded to 1 mm. The path is thinned to a point for each 0.1 m.
[[nodiscard]] std::string report_data(const ReportSources& from);

}  // namespace roomatlas
