// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/pipeline/assemble_map.hpp"

#include <algorithm>
#include <utility>

#include "draw_up.hpp"
#include "put_assembly.hpp"
#include "roomatlas/draft/building_axes.hpp"
#include "roomatlas/edit/edit_building.hpp"

namespace roomatlas {
namespace {

constexpr double kThickestWall_m = 0.8;  // of a map: between two drawn faces nobody saw anything;
                                         // larger takes narrow shafts for walls

}  // namespace

Assembly assemble_map(const MapCells& map, const Options& options, const Progress& progress) {
  const AssembleOptions& assemble = options.assemble;
  report(progress, "map building", 0.0);
  const BuildingEvidence evidence = evidence_of_map(map);
  Assembly assembly;
  if (evidence.surfaces.empty()) return assembly;
  report(progress, "draft", -1.0);
  DraftBuildingOptions draft = assemble.draft;
  draft.walls.thickest_m = std::max(draft.walls.thickest_m, kThickestWall_m);
  MappedBuilding building = moved(mapped_building_of(draft_building(evidence, draft, options.jobs),
                                                     evidence, options.map.record.map),
                                  map.building_from_map);
  const Issues edits = edit_building(assemble.edits, building);
  assembly.doors = building.doors;
  report(progress, "merge", -1.0);
  draw_up(std::move(building), assemble, assembly);
  assembly.plan.issues.insert(assembly.plan.issues.end(), edits.begin(), edits.end());
  return assembly;
}

Assembly assemble_map(AssemblyStore& store, const MapCells& map, const Options& options,
                      const std::string& configuration, const Progress& progress) {
  Assembly assembly = assemble_map(map, options, progress);
  put_with_former_rooms(store, configuration, assembly);
  return assembly;
}

}  // namespace roomatlas
