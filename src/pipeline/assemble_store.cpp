// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/pipeline/assemble_store.hpp"

#include <utility>

#include "put_assembly.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/merge/carry_over.hpp"
#include "roomatlas/pipeline/assemble.hpp"
#include "roomatlas/pipeline/assemble_joined.hpp"
#include "roomatlas/trust/judge_map.hpp"

namespace roomatlas {

void put_with_former_rooms(AssemblyStore& store, const std::string& configuration,
                           Assembly& assembly) {
  assembly.plan.title = store.mission().file;
  CarriedOver carried = carry_over(store.former_rooms(), assembly.plan, assembly.room_of_asr);
  assembly.absent_rooms = std::move(carried.absent);
  if (assembly.measured_plan) renumber(*assembly.measured_plan, carried.number);
  if (assembly.judgement) assembly.judgement = judged_anew(*assembly.judgement, assembly);
  store.put(assembly, configuration);
}

Assembly assemble_store(AssemblyStore& store, const Options& options,
                        const std::string& configuration, const Progress& progress) {
  if (std::vector<MemberMission> members = store.members(); !members.empty()) {
    JoinedBuilding building;
    building.members = std::move(members);
    building.placement = placement_of(store.correction());
    building.closures = store.closures();
    return assemble_joined(store, building, options, configuration, progress);
  }
  if (!options.assemble.missions.empty()) {
    throw UsageError("--missions: the store is of one mission, there is nothing to choose from");
  }
  Assembly assembly = assemble(store, store.mission().footprint, options, progress);
  put_with_former_rooms(store, configuration, assembly);
  return assembly;
}

}  // namespace roomatlas
