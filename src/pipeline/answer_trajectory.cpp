// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/pipeline/answer_trajectory.hpp"

#include <utility>

#include "roomatlas/asr/memory_store.hpp"
#include "roomatlas/asr/with_paths.hpp"
#include "roomatlas/correct/place.hpp"
#include "roomatlas/pipeline/assemble.hpp"

namespace roomatlas {

Trajectory answer_trajectory(const AsrSource& source, const RobotFootprint& footprint,
                             const Options& options, const Progress& progress) {
  Assembly assembly = assemble(source, footprint, options, progress);
  if (assembly.mapped_again.empty()) {
    return place(WithPaths(source, assembly.paths), assembly.correction).corrected;
  }
  MemoryStore again;
  again.asrs = std::move(assembly.mapped_again);
  return place(again, assembly.correction).corrected;
}

}  // namespace roomatlas
