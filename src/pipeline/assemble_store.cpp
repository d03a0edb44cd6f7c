// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/pipeline/assemble_store.hpp"

#include "roomatlas/merge/carry_over.hpp"
#include "roomatlas/pipeline/assemble.hpp"

namespace roomatlas {

Assembly assemble_store(AssemblyStore& store, const Options& options,
                        const std::string& configuration, const Progress& progress) {
  const StoredMission mission = store.mission();
  Assembly assembly = assemble(store, mission.footprint, options, progress);
  assembly.plan.title = mission.file;
  const CarriedOver carried = carry_over(store.former_rooms(), assembly.plan, assembly.room_of_asr);
  if (assembly.measured_plan) renumber(*assembly.measured_plan, carried.number);
  store.put(assembly, configuration);
  return assembly;
}

}  // namespace roomatlas
