// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "roomatlas/assembly/assembly.hpp"
#include "roomatlas/evaluate/self_consistency.hpp"
#include "roomatlas/loops/visit_graph.hpp"
#include "roomatlas/mission/mission.hpp"
#include "roomatlas/plan/judgement.hpp"

namespace roomatlas {

/// What is measured of a corrected map, for judging how likely it is right. Nothing of it is known
/// from truth. Figures are on scales on which they are about linear in the log odds; each list has
/// the same names for every mission of a kind of sensor.
struct MapFigures {
  SensorKind sensor = SensorKind::laser;
  std::vector<JudgedFigure> figures;
  std::vector<VisitJudgement> visits;  ///< ascending by ASR; not judged yet
};

/// @param source the visits as they were corrected, with readings
/// @param correct options of the correction, by which its uncertainty is told
/// @param jobs threads at once, see `for_each_index`; so many visits' readings are loaded at a time
/// Without readings, or of a finished map, the list of figures is empty.
[[nodiscard]] MapFigures map_figures(const AsrSource& source, const Assembly& assembly,
                                     const CorrectOptions& correct, int jobs = 1);

}  // namespace roomatlas
