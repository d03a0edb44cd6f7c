// SPDX-License-Identifier: GPL-3.0-or-later
#include "latest_building.hpp"

#include <algorithm>
#include <limits>

#include "draw_up.hpp"
#include "roomatlas/asr/joined_source.hpp"
#include "roomatlas/changes/latest_state.hpp"
#include "roomatlas/draft/draft_building.hpp"

namespace roomatlas {
namespace {

/// The visits of some missions, and from when to when they were driven.
struct TimeStretch {
  double first_s = std::numeric_limits<double>::infinity();
  double last_s = -std::numeric_limits<double>::infinity();
  VisitsOfTime of;
};

TimeStretch stretch_of(const MemberMission& member, const std::vector<Asr>& asrs) {
  TimeStretch stretch;
  stretch.of.mission = member.name;
  for (const Asr& asr : asrs) {
    if (asr.id < member.first_asr || asr.id > member.last_asr) continue;
    stretch.of.visits.push_back(asr.id);
    for (const PathSample& sample : asr.path) {
      stretch.first_s = std::min(stretch.first_s, sample.timestamp_s);
      stretch.last_s = std::max(stretch.last_s, sample.timestamp_s);
    }
  }
  return stretch;
}

void add(const TimeStretch& more, TimeStretch& to) {
  to.last_s = std::max(to.last_s, more.last_s);
  to.of.mission += ", " + more.of.mission;
  to.of.visits.insert(to.of.visits.end(), more.of.visits.begin(), more.of.visits.end());
  std::sort(to.of.visits.begin(), to.of.visits.end());
}

/// Missions of one building, as they are compared.
class Comparer {
 public:
  Comparer(const AsrSource& source, const Placement& placement, const RobotFootprint& footprint,
           const Options& options, const Progress& progress)
      : source_(source),
        placement_(placement),
        footprint_(footprint),
        options_(options),
        progress_(progress) {
    changes_.evidence = options.assemble.draft.evidence;
  }

  [[nodiscard]] const ChangeOptions& changes() const { return changes_; }

  [[nodiscard]] BuildingEvidence gathered(const std::vector<AsrId>& visits) const {
    return gather_evidence(SelectedAsrs(source_, visits), placement_, footprint_, changes_.evidence,
                           progress_, options_.jobs);
  }

  /// What changed.
  [[nodiscard]] std::vector<Change> between(const LatestState& before,
                                            const BuildingEvidence& later,
                                            const std::vector<AsrId>& visits) const {
    std::vector<AsrId> earlier;
    for (const auto& [visit, time] : before.times.of_visit) earlier.push_back(visit);
    const SelectedAsrs source_before(source_, earlier);
    const SelectedAsrs source_after(source_, visits);
    const AssembledMission old_state{&source_before, placement_,       {},
                                     footprint_,     &before.evidence, &before.times};
    const AssembledMission new_state{&source_after, placement_, {}, footprint_, &later};
    const auto plans = [&] {
      return PlansOfBoth{drafted(as_drafted(before.evidence, before, changes_)), drafted(later)};
    };
    return changes_between(old_state, new_state, changes_, plans, progress_, options_.jobs);
  }

 private:
  [[nodiscard]] FloorPlan drafted(const BuildingEvidence& evidence) const {
    const AssembleOptions& assemble = options_.assemble;
    Assembly assembly;
    draw_up(mapped_building_of(draft_building(evidence, assemble.draft, options_.jobs), evidence,
                               options_.map.record.map),
            assemble, assembly);
    return std::move(assembly.plan);
  }

  const AsrSource& source_;
  const Placement& placement_;
  const RobotFootprint& footprint_;
  const Options& options_;
  const Progress& progress_;
  ChangeOptions changes_;
};

}  // namespace

std::vector<VisitsOfTime> in_order_of_time(const std::vector<Asr>& asrs,
                                           const std::vector<MemberMission>& members,
                                           const std::set<AsrId>& left_out) {
  std::vector<TimeStretch> stretches;
  for (const MemberMission& member : members) {
    TimeStretch stretch = stretch_of(member, asrs);
    const auto& visits = stretch.of.visits;
    if (visits.empty() || left_out.contains(visits.front())) continue;
    stretches.push_back(std::move(stretch));
  }
  std::stable_sort(
      stretches.begin(), stretches.end(),
      [](const TimeStretch& a, const TimeStretch& b) { return a.first_s < b.first_s; });
  std::vector<TimeStretch> times;
  for (TimeStretch& stretch : stretches) {
    if (!times.empty() && stretch.first_s <= times.back().last_s) {
      add(stretch, times.back());
    } else {
      times.push_back(std::move(stretch));
    }
  }
  std::vector<VisitsOfTime> in_order;
  in_order.reserve(times.size());
  for (TimeStretch& time : times) in_order.push_back(std::move(time.of));
  return in_order;
}

LatestBuilding latest_building(const AsrSource& source, const Placement& placement,
                               const std::vector<VisitsOfTime>& times,
                               const RobotFootprint& footprint, const Options& options,
                               const Progress& progress) {
  const Comparer comparer(source, placement, footprint, options, progress);
  LatestBuilding latest;
  LatestState state;
  if (times.size() > 1) {
    state.evidence = comparer.gathered(times.front().visits);
    for (const AsrId visit : times.front().visits) state.times.of_visit[visit] = 0;
  }
  for (std::size_t i = 1; i < times.size(); ++i) {
    const BuildingEvidence later = comparer.gathered(times[i].visits);
    const std::vector<Change> changes = comparer.between(state, later, times[i].visits);
    take_in(later, changes, comparer.changes(), state);
    if (changes.empty()) continue;
    SeenLast& told = latest.told.emplace_back(SeenLast{times[i].mission, {}});
    for (const Change& change : changes) {
      told.things.push_back({change.kind, change.at, change.size_m});
    }
  }
  latest.evidence = gather_evidence(source, placement, footprint, comparer.changes().evidence,
                                    progress, options.jobs);
  if (!latest.told.empty()) {
    latest.evidence = as_drafted(std::move(latest.evidence), state, comparer.changes());
  }
  for (const ShutDoor& door : state.shut) latest.shut_doors.push_back(door.line);
  return latest;
}

void shut(const std::vector<Segment2>& lines, std::vector<Door>& doors) {
  for (const Segment2& line : lines) {
    const Point2 middle = (line.a + line.b) / 2.0;
    for (Door& door : doors) {
      const bool is_it = door.kind == DoorKind::door &&
                         (door.frame_from_pivot.position() - middle).norm() < kSameDoor_m;
      if (is_it) door.leaf = door.jambs;
    }
  }
}

std::vector<SeenLast> moved(std::vector<SeenLast> told, const Pose2& to_from_here) {
  for (SeenLast& one : told) {
    for (ThingSeenLast& thing : one.things) thing.at = to_from_here * thing.at;
  }
  return told;
}

}  // namespace roomatlas
