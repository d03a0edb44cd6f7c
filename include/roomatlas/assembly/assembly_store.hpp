// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "roomatlas/asr/store.hpp"
#include "roomatlas/assembly/assembly.hpp"
#include "roomatlas/assembly/member_mission.hpp"
#include "roomatlas/correct/correction.hpp"
#include "roomatlas/mission/mission.hpp"
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

/// What a store knows of the mission behind its ASRs.
struct StoredMission {
  std::string file;  ///< name of the log; empty where nobody said
  RobotFootprint footprint;
};

/// A mission's ASRs and what was made of them.
class AssemblyStore : public AsrSource {
 public:
  [[nodiscard]] virtual StoredMission mission() const = 0;

  /// The missions that it was joined from, in the order of their visits; none where it is one.
  [[nodiscard]] virtual std::vector<MemberMission> members() const { return {}; }

  /// Replaces what an earlier assembly left, in one transaction: whoever opens the store sees the
  /// old assembly or the new one, whole, whenever the program ends.
  /// @param configuration all parameters that it was made with (TOML)
  virtual void put(const Assembly& assembly, const std::string& configuration) = 0;

  [[nodiscard]] virtual bool has_assembly() const = 0;
  /// The last assembly. Throws InputError where there is none.
  [[nodiscard]] virtual Correction correction() const = 0;
  /// See `Assembly::other_answer`.
  [[nodiscard]] virtual Placement other_answer() const { return {}; }
  [[nodiscard]] virtual FloorPlan plan() const = 0;
  /// The matches of rooms that were tried.
  [[nodiscard]] virtual std::vector<Closure> closures() const { return {}; }
  /// Rooms whose numbers and names the next assembly carries over: those of the plan that is there,
  /// else those of a store that this one replaced.
  [[nodiscard]] virtual std::vector<PlanRoom> former_rooms() const = 0;
};

}  // namespace roomatlas
