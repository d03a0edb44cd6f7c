// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/changes/find_changes.hpp"

#include <algorithm>
#include <optional>

#include "things.hpp"
#include "unseen.hpp"

namespace roomatlas {
namespace {

using namespace changes;

CellBox around(const CellBox& a, const CellBox& b) {
  if (a.count() == 0) return b;
  if (b.count() == 0) return a;
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y)}};
}

/// The ASRs of a mission that have a place.
class PlacedVisits : public AsrSource {
 public:
  explicit PlacedVisits(const AssembledMission& mission) : mission_(mission) {}

  [[nodiscard]] std::vector<AsrId> ids() const override {
    std::vector<AsrId> ids = mission_.source->ids();
    std::erase_if(ids, [&](AsrId id) { return !mission_.placement.contains(id); });
    return ids;
  }
  [[nodiscard]] Asr get(AsrId id, AsrDetail detail) const override {
    return mission_.source->get(id, detail);
  }
  [[nodiscard]] std::vector<TruePose> truth() const override { return mission_.source->truth(); }

 private:
  const AssembledMission& mission_;
};

/// Enough readings of it, over long enough, and enough that say that it is not there.
bool is_sure(const Altered& altered, const ChangeOptions& options) {
  const Witness& of_it = altered.is_new ? altered.after : altered.before;
  const Witness& of_nothing = altered.is_new ? altered.before : altered.after;
  return of_it.hits >= options.min_readings && of_it.lasting_s >= options.min_lasting_s &&
         of_it.hits >= options.least_standing * (of_it.hits + of_it.passes) &&
         of_nothing.passes >= options.min_readings;
}

/// A mission, and what it says of the cells.
struct Compared {
  AssembledMission mission;
  const BuildingEvidence& evidence;
  SeenCells cells;
};

/// The evidence of a mission: what came with it, or gathered here.
class Gathered {
 public:
  Gathered(const AssembledMission& mission, const ChangeOptions& options, const Progress& progress,
           int jobs)
      : visits_(mission), mission_(mission) {
    mission_.source = &visits_;
    if (mission.evidence != nullptr) return;
    own_ = gather_evidence(visits_, mission.placement, mission.footprint, options.evidence,
                           progress, jobs);
  }
  Gathered(const Gathered&) = delete;
  Gathered& operator=(const Gathered&) = delete;

  [[nodiscard]] const BuildingEvidence& evidence() const {
    return own_ ? *own_ : *mission_.evidence;
  }
  [[nodiscard]] Compared in(const CellBox& box, const ChangeOptions& options) const {
    return {mission_, evidence(), seen_cells(evidence(), mission_.times, box, options)};
  }

 private:
  PlacedVisits visits_;
  AssembledMission mission_;
  std::optional<BuildingEvidence> own_;
};

/// Both missions' groups of cells, with what their readings say of them.
std::vector<Altered> altered_in(const Compared& before, const Compared& after,
                                const ChangeOptions& options, const Progress& progress, int jobs) {
  if (before.evidence.kind != SensorKind::laser || after.evidence.kind != SensorKind::laser) {
    return {};
  }
  const CellFrame frame{options.evidence.cell_m};
  std::vector<CellGroup> groups =
      groups_of(only_in(before.cells, after.cells, frame.cell_m, options), frame.cell_m, options);
  const std::size_t gone = groups.size();
  const std::vector<CellGroup> appeared =
      groups_of(only_in(after.cells, before.cells, frame.cell_m, options), frame.cell_m, options);
  groups.insert(groups.end(), appeared.begin(), appeared.end());
  const auto asked = [&](const Compared& one) {
    return ask(one.mission, visits_near(one.evidence, groups, options.evidence), groups,
               options.evidence, progress, jobs);
  };
  const auto by_before = asked(before);
  const auto by_after = asked(after);

  std::vector<Altered> altered;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    Altered one{i >= gone, {}, by_before[i], by_after[i]};
    for (const Cell& cell : groups[i]) one.points.push_back(frame.center_of(cell));
    if (is_sure(one, options)) altered.push_back(std::move(one));
  }
  return altered;
}

}  // namespace

std::vector<Change> changes_between(const AssembledMission& before, const AssembledMission& after,
                                    const ChangeOptions& options,
                                    const std::function<PlansOfBoth()>& plans,
                                    const Progress& progress, int jobs) {
  const Gathered of_before(before, options, progress, jobs);
  const Gathered of_after(after, options, progress, jobs);
  const CellBox box = around(of_before.evidence().counts.box(), of_after.evidence().counts.box());
  const std::vector<Altered> altered =
      altered_in(of_before.in(box, options), of_after.in(box, options), options, progress, jobs);
  if (altered.empty()) return {};
  const PlansOfBoth names = plans();
  return changes_of(altered, names.before, names.after, options);
}

PlanChanges find_changes(const AssembledMission& before, const AssembledMission& after,
                         const ChangeOptions& options, const Progress& progress, int jobs) {
  const Gathered of_before(before, options, progress, jobs);
  const Gathered of_after(after, options, progress, jobs);
  const CellFrame frame{options.evidence.cell_m};
  const CellBox box = around(of_before.evidence().counts.box(), of_after.evidence().counts.box());
  const Compared then = of_before.in(box, options);
  const Compared now = of_after.in(box, options);

  PlanChanges found;
  found.tells_changes =
      then.evidence.kind == SensorKind::laser && now.evidence.kind == SensorKind::laser;
  found.changes =
      changes_of(altered_in(then, now, options, progress, jobs), before.plan, after.plan, options);
  const Seen seen_before{then.cells, then.evidence.building_from_robot, before.plan};
  const Seen seen_after{now.cells, now.evidence.building_from_robot, after.plan};
  found.rooms = one_sided_rooms(seen_before, seen_after, frame);
  found.not_seen_again = not_seen_again(seen_before, now.cells, frame, options);
  found.compared_m2 = static_cast<double>(both(then.cells.clear, now.cells.clear).count()) *
                      frame.cell_m * frame.cell_m;
  return found;
}

}  // namespace roomatlas
