// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/evaluation.hpp"

namespace roomatlas {
namespace {

std::map<AsrId, RoomId> rooms_of(const FloorPlan& plan) {
  std::map<AsrId, RoomId> room_of;
  for (const PlanRoom& room : plan.rooms) {
    for (const AsrId asr : room.asrs) room_of[asr] = room.id;
  }
  return room_of;
}

struct Placements {
  Placement before;
  Placement after;
};

Placements placements_of(const Correction& correction) {
  Placements placements;
  for (const AsrCorrection& asr : correction.asrs) {
    placements.before[asr.asr] = asr.building_from_asr_before;
    placements.after[asr.asr] = asr.building_from_asr;
  }
  return placements;
}

/// The path of each ASR of a room; ASRs that no room has are left out.
std::vector<PlacedVisit> visits_of(const AsrSource& source, const Placement& placement,
                                   const std::map<AsrId, RoomId>& room_of) {
  std::vector<PlacedVisit> visits;
  for (const auto& [id, building_from_asr] : placement) {
    const auto room = room_of.find(id);
    if (room == room_of.end()) continue;
    PlacedVisit& visit = visits.emplace_back();
    visit.asr = id;
    visit.room = room->second;
    for (const PathSample& sample : source.get(id, AsrDetail::path).path) {
      visit.path.push_back({sample.timestamp_s, building_from_asr * sample.asr_from_robot});
    }
  }
  return visits;
}

/// The path of a placement, for its own alignment with the truth.
Trajectory path_of(const std::vector<PlacedVisit>& visits) {
  Trajectory path;
  for (const PlacedVisit& visit : visits) {
    path.insert(path.end(), visit.path.begin(), visit.path.end());
  }
  return path;
}

RoomPoseErrors pose_errors_of(const std::vector<PlacedVisit>& visits, const Trajectory& truth) {
  return room_pose_errors(visits, truth,
                          true_pose_errors(path_of(visits), truth).truth_from_building);
}

}  // namespace

void judge_placements(const AsrSource& source, const Correction& correction, const FloorPlan& plan,
                      const Truth& truth, Evaluation& evaluation, int jobs) {
  if (correction.asrs.empty()) return;  // a finished map: nothing was placed
  const std::map<AsrId, RoomId> room_of = rooms_of(plan);
  const Placements placements = placements_of(correction);
  if (!truth.poses.empty()) {
    evaluation.room_poses = {
        pose_errors_of(visits_of(source, placements.before, room_of), truth.poses),
        pose_errors_of(visits_of(source, placements.after, room_of), truth.poses)};
  }
  ConsistencyOptions options;
  options.jobs = jobs;
  const std::vector<AsrEvidence> evidence = evidence_of(source, options.evidence, jobs);
  evaluation.consistency =
      compare(self_consistency(evidence, placements.before, room_of, options),
              self_consistency(evidence, placements.after, room_of, options), {});
}

}  // namespace roomatlas
