// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/changes/find_changes.hpp"

#include <algorithm>

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
  const AssembledMission& mission;
  const SeenCells& cells;
};

/// Both missions' groups of cells, with what their readings say of them.
std::vector<Altered> altered_in(const Compared& before, const Compared& after,
                                const ChangeOptions& options, const Progress& progress, int jobs) {
  const CellFrame frame{options.evidence.cell_m};
  std::vector<CellGroup> groups =
      groups_of(only_in(before.cells, after.cells, frame.cell_m, options), frame.cell_m, options);
  const std::size_t gone = groups.size();
  const std::vector<CellGroup> appeared =
      groups_of(only_in(after.cells, before.cells, frame.cell_m, options), frame.cell_m, options);
  groups.insert(groups.end(), appeared.begin(), appeared.end());
  const auto by_before = ask(before.mission, groups, options.evidence, progress, jobs);
  const auto by_after = ask(after.mission, groups, options.evidence, progress, jobs);

  std::vector<Altered> altered;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    Altered one{i >= gone, {}, by_before[i], by_after[i]};
    for (const Cell& cell : groups[i]) one.points.push_back(frame.center_of(cell));
    if (is_sure(one, options)) altered.push_back(std::move(one));
  }
  return altered;
}

}  // namespace

PlanChanges find_changes(const AssembledMission& all_before, const AssembledMission& all_after,
                         const ChangeOptions& options, const Progress& progress, int jobs) {
  const PlacedVisits visits_before(all_before);
  const PlacedVisits visits_after(all_after);
  const AssembledMission before{&visits_before, all_before.placement, all_before.plan,
                                all_before.footprint};
  const AssembledMission after{&visits_after, all_after.placement, all_after.plan,
                               all_after.footprint};
  const auto gathered = [&](const AssembledMission& mission) {
    return gather_evidence(*mission.source, mission.placement, mission.footprint, options.evidence,
                           progress, jobs);
  };
  const BuildingEvidence of_before = gathered(before);
  const BuildingEvidence of_after = gathered(after);
  const CellFrame frame{options.evidence.cell_m};
  const CellBox box = around(of_before.counts.box(), of_after.counts.box());
  const SeenCells then = seen_cells(of_before, box, options);
  const SeenCells now = seen_cells(of_after, box, options);

  PlanChanges found;
  found.tells_changes = of_before.kind == SensorKind::laser && of_after.kind == SensorKind::laser;
  if (found.tells_changes) {
    const std::vector<Altered> altered =
        altered_in({before, then}, {after, now}, options, progress, jobs);
    found.changes = changes_of(altered, before.plan, after.plan, options);
  }
  const Seen seen_before{then, of_before.building_from_robot, before.plan};
  const Seen seen_after{now, of_after.building_from_robot, after.plan};
  found.rooms = one_sided_rooms(seen_before, seen_after, frame);
  found.not_seen_again = not_seen_again(seen_before, now, frame, options);
  found.compared_m2 =
      static_cast<double>(both(then.clear, now.clear).count()) * frame.cell_m * frame.cell_m;
  return found;
}

}  // namespace roomatlas
