// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "roomatlas/assembly/assembly_store.hpp"
#include "roomatlas/core/progress.hpp"
#include "roomatlas/join/join_missions.hpp"
#include "roomatlas/pipeline/options.hpp"

namespace roomatlas {

/// What of several missions holds together, or one that nothing holds. Visits are numbered as
/// `JoinedSource` numbers those of `missions`.
struct JoinedBuilding {
  std::vector<std::size_t> missions;  ///< indices of the stores that were given, the base first
  std::vector<std::size_t> answered_otherwise;  ///< those of them whose other answer was joined
  std::vector<MemberMission> members;           ///< of all of these stores
  Placement placement;
  std::vector<Closure> closures;                ///< tried between visits of different missions
  PlaceVerdict verdict = PlaceVerdict::placed;  ///< why it stands alone, where it does
};

/// Looks for each mission in the others, see `join_missions`, in an order that hangs on the
/// missions alone: first what was joined already, lasers before sonars, the larger before the
/// smaller. Among its equals, the base that is asked for comes before larger ones.
/// @param stores assembled, with readings; a store of several missions counts as one
/// @param workers see `join_missions`
/// @param base index of the store in whose frame people know the building, if any is
/// @returns that of the most missions first
/// @throws InputError for a store that is not assembled or has no readings
[[nodiscard]] std::vector<JoinedBuilding> join_stores(
    const std::vector<const AssemblyStore*>& stores, const Options& options,
    const Progress& progress, const Workers& workers, std::optional<std::size_t> base = {});

/// The floor plan of several missions of one building into a store that has their visits already,
/// see `JoinedSource`: drafted from all readings of its lasers, or of its sonars where there are no
/// lasers; visits of sonars are then given to the rooms that they lie in. Missions of lasers that
/// were driven one after the other are drawn as the latest of them saw the building, see
/// `Assembly::seen_last`, unless `draw_latest` is off. Rooms get the numbers and
/// names of the store's former rooms.
/// @param configuration of `options`, as it is to stand in the store (TOML)
/// @returns what was put
[[nodiscard]] Assembly assemble_joined(AssemblyStore& store, const JoinedBuilding& building,
                                       const Options& options, const std::string& configuration,
                                       const Progress& progress = {});

}  // namespace roomatlas
