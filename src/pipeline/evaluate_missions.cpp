// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate_missions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "roomatlas/core/issue.hpp"
#include "roomatlas/correct/correct.hpp"
#include "roomatlas/correct/place.hpp"

namespace roomatlas {
namespace {

constexpr double kBetweenMissions_s = 60.0;  ///< where their times have to be parted

/// First and last time of a trajectory; false where there is none.
struct TimeSpan {
  double first_s = 0.0;
  double last_s = 0.0;
  bool is_there = false;

  [[nodiscard]] bool holds(double time_s) const {
    return is_there && time_s >= first_s - 1e-6 && time_s <= last_s + 1e-6;
  }
};

TimeSpan span_of(const Trajectory& trajectory) {
  TimeSpan span;
  for (const StampedPose& pose : trajectory) {
    if (!std::isfinite(pose.timestamp_s)) continue;
    span.first_s = span.is_there ? std::min(span.first_s, pose.timestamp_s) : pose.timestamp_s;
    span.last_s = span.is_there ? std::max(span.last_s, pose.timestamp_s) : pose.timestamp_s;
    span.is_there = true;
  }
  return span;
}

std::vector<TimeSpan> spans_of(const std::vector<Trajectory>& trajectories) {
  std::vector<TimeSpan> spans;
  spans.reserve(trajectories.size());
  for (const Trajectory& trajectory : trajectories) spans.push_back(span_of(trajectory));
  return spans;
}

/// Whether two missions are parts of one recording: where both have a time, odometry is the same.
bool is_one_recording(const Trajectory& first, const Trajectory& second) {
  std::map<double, Pose2> poses;
  for (const StampedPose& pose : first) poses.emplace(pose.timestamp_s, pose.pose);
  std::size_t shared = 0;
  for (const StampedPose& pose : second) {
    const auto there = poses.find(pose.timestamp_s);
    if (there == poses.end()) continue;
    const Pose2 off = inverse(there->second) * pose.pose;
    if (off.position().norm() > 1e-6 || std::abs(off.theta_rad) > 1e-6) return false;
    ++shared;
  }
  return shared > 0;
}

/// Whether any time may be that of two missions, so that it does not tell which is meant.
/// @param odometry of each mission, as in its log
bool do_clocks_clash(const std::vector<TimeSpan>& spans, const std::vector<Trajectory>& odometry) {
  for (std::size_t i = 0; i < spans.size(); ++i) {
    for (std::size_t k = i + 1; k < spans.size(); ++k) {
      const bool meet = spans[i].is_there && spans[k].is_there &&
                        spans[i].first_s <= spans[k].last_s && spans[k].first_s <= spans[i].last_s;
      if (meet && !is_one_recording(odometry[i], odometry[k])) return true;
    }
  }
  return false;
}

/// Where one mission's odometry and correction put it.
PlacedMission placed_mission(const AsrSource& source, Correction correction,
                             const MemberMission& member) {
  std::erase_if(correction.asrs, [&](const AsrCorrection& asr) {
    return asr.asr < member.first_asr || asr.asr > member.last_asr;
  });
  return place(source, correction);
}

/// Odometry that begins where the corrected path begins.
Trajectory begun_at(const Trajectory& corrected, Trajectory odometry) {
  if (corrected.empty()) return odometry;
  const Pose2 begun = corrected.front().pose * inverse(odometry.front().pose);
  for (StampedPose& pose : odometry) pose.pose = begun * pose.pose;
  return odometry;
}

/// The truth of each mission, in its own clock: what is named, else what came with it.
std::vector<TruthOfMission> own_truths(const AssemblyStore& store,
                                       const std::vector<MemberMission>& members,
                                       const Truth& truth) {
  std::vector<TruthOfMission> own(members.size());
  for (const TruthOfMission& named : truth.missions) {
    TruthOfMission& mission = own[index_of(members, named.mission)];
    mission.relations.insert(mission.relations.end(), named.relations.begin(),
                             named.relations.end());
    mission.poses.insert(mission.poses.end(), named.poses.begin(), named.poses.end());
  }
  if (!truth.poses.empty()) return own;
  const Trajectory stored = true_poses_of(store);
  auto next = stored.begin();
  for (std::size_t i = 0; i < members.size(); ++i) {
    const auto last = next + std::min<std::ptrdiff_t>(members[i].true_poses, stored.end() - next);
    if (own[i].poses.empty()) own[i].poses.assign(next, last);
    next = last;
  }
  return own;
}

void append_later(const Trajectory& some, double later_s, Trajectory& all) {
  for (const StampedPose& pose : some) all.push_back({pose.timestamp_s + later_s, pose.pose});
}

/// The same ASRs with the times of `JoinedPaths`.
class LaterAsrs : public AsrSource {
 public:
  LaterAsrs(const AsrSource& source, const std::vector<MemberMission>& members,
            const std::vector<double>& later_s)
      : source_(source), members_(members), later_s_(later_s) {}

  [[nodiscard]] std::vector<AsrId> ids() const override { return source_.ids(); }
  [[nodiscard]] Asr get(AsrId id, AsrDetail detail) const override {
    Asr asr = source_.get(id, detail);
    for (std::size_t i = 0; i < members_.size(); ++i) {
      if (id < members_[i].first_asr || id > members_[i].last_asr) continue;
      asr.start_s += later_s_[i];
      asr.end_s += later_s_[i];
      for (PathSample& sample : asr.path) sample.timestamp_s += later_s_[i];
    }
    return asr;
  }
  [[nodiscard]] std::vector<TruePose> truth() const override { return {}; }

 private:
  const AsrSource& source_;
  const std::vector<MemberMission>& members_;
  const std::vector<double>& later_s_;
};

/// Relations with both times in one span.
std::vector<Relation> within(const std::vector<Relation>& relations, const TimeSpan& span) {
  std::vector<Relation> some;
  std::copy_if(relations.begin(), relations.end(), std::back_inserter(some),
               [&](const Relation& one) { return span.holds(one.t1_s) && span.holds(one.t2_s); });
  return some;
}

/// Relations that lead from one mission to another.
std::vector<Relation> between(const std::vector<Relation>& relations,
                              const std::vector<TimeSpan>& spans) {
  const auto any = [&](auto holds) { return std::any_of(spans.begin(), spans.end(), holds); };
  std::vector<Relation> some;
  for (const Relation& one : relations) {
    const bool in_one =
        any([&](const TimeSpan& span) { return span.holds(one.t1_s) && span.holds(one.t2_s); });
    const bool in_some = any([&](const TimeSpan& span) { return span.holds(one.t1_s); }) &&
                         any([&](const TimeSpan& span) { return span.holds(one.t2_s); });
    if (in_some && !in_one) some.push_back(one);
  }
  return some;
}

/// Of one mission, with the times of all together.
MissionErrors errors_of(const JoinedPaths& paths, std::size_t mission, const TimeSpan& span,
                        const TrajectoryPreparation& preparation,
                        const std::optional<TruePosesBeforeAfter>& all) {
  Trajectory odometry;
  Trajectory corrected;
  append_later(paths.odometry[mission], paths.later_s[mission], odometry);
  append_later(paths.corrected[mission], paths.later_s[mission], corrected);
  Truth truth;
  truth.relations = within(paths.relations, span);
  truth.poses = paths.poses;
  Evaluation alone =
      evaluate(odometry, corrected, {}, truth, preparation.relations, preparation.carry);
  MissionErrors errors;
  errors.relations = std::move(alone.relations);
  if (!alone.true_poses || alone.true_poses->after.matched == 0) return errors;
  errors.true_poses = std::move(alone.true_poses);
  const PlacedPoseErrors placed =
      placed_pose_errors(corrected, truth.poses, all->after.truth_from_building);
  errors.in_building_m = placed.position_m;
  errors.in_building_deg = placed.heading_deg;
  return errors;
}

}  // namespace

JoinedPaths joined_paths(const AssemblyStore& store, const Truth& truth,
                         const TrajectoryPreparation& preparation) {
  const std::vector<MemberMission> members = store.members();
  const Correction correction = store.correction();
  JoinedPaths paths;
  std::vector<Trajectory> recorded;
  for (const MemberMission& member : members) {
    PlacedMission placed = placed_mission(store, correction, member);
    const auto prepared = [&](const char* what, Trajectory trajectory) {
      return preparation.prepare
                 ? preparation.prepare(member.name + " " + what, std::move(trajectory))
                 : trajectory;
    };
    recorded.push_back(placed.odometry);
    paths.odometry.push_back(
        prepared("odometry", begun_at(placed.corrected, std::move(placed.odometry))));
    paths.corrected.push_back(prepared("corrected", std::move(placed.corrected)));
  }
  const std::vector<TimeSpan> spans = spans_of(paths.corrected);
  const bool is_shared = do_clocks_clash(spans, recorded);
  if (is_shared && (!truth.poses.empty() || !truth.relations.empty())) {
    throw UsageError(
        "the times of the missions overlap: say whose truth it is, --truth MISSION=FILE with the "
        "mission's name or number");
  }
  paths.later_s.assign(members.size(), 0.0);
  paths.relations = truth.relations;
  paths.poses = truth.poses;
  const std::vector<TruthOfMission> own = own_truths(store, members, truth);
  double end_s = 0.0;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (is_shared && spans[i].is_there) paths.later_s[i] = end_s - spans[i].first_s;
    end_s += spans[i].last_s - spans[i].first_s + kBetweenMissions_s;
    append_later(paths.odometry[i], paths.later_s[i], paths.all_odometry);
    append_later(paths.corrected[i], paths.later_s[i], paths.all_corrected);
    append_later(own[i].poses, paths.later_s[i], paths.poses);
    for (Relation relation : own[i].relations) {
      relation.t1_s += paths.later_s[i];
      relation.t2_s += paths.later_s[i];
      paths.relations.push_back(relation);
    }
  }
  return paths;
}

Evaluation evaluate_missions(const AssemblyStore& store, const Truth& truth,
                             const TrajectoryPreparation& preparation, int jobs) {
  const std::vector<MemberMission> members = store.members();
  const Correction correction = store.correction();
  const FloorPlan plan = store.plan();
  const JoinedPaths paths = joined_paths(store, truth, preparation);
  Truth joint;
  joint.relations = paths.relations;
  joint.poses = paths.poses;
  joint.plan = truth.plan;
  joint.plan_has_doors = truth.plan_has_doors;
  joint.spans = truth.spans;
  Evaluation evaluation = evaluate(paths.all_odometry, paths.all_corrected, plan, joint,
                                   preparation.relations, preparation.carry);
  judge_placements(LaterAsrs(store, members, paths.later_s), correction, plan, joint, evaluation,
                   jobs);

  MissionsEvaluation missions;
  missions.figures =
      mission_figures(store, placement_of(correction), members, store.closures(), plan);
  std::vector<TimeSpan> spans;
  for (std::size_t i = 0; i < members.size(); ++i) {
    Trajectory corrected;
    append_later(paths.corrected[i], paths.later_s[i], corrected);
    spans.push_back(span_of(corrected));
    missions.errors.push_back(
        errors_of(paths, i, spans.back(), preparation, evaluation.true_poses));
    missions.errors.back().name = members[i].name;
  }
  const std::vector<Relation> across = between(joint.relations, spans);
  if (!across.empty()) {
    missions.between =
        relation_errors(paths.all_corrected, across, preparation.relations, preparation.carry);
  }
  evaluation.missions = std::move(missions);
  return evaluation;
}

}  // namespace roomatlas
