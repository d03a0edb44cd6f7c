// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/pipeline/assemble_joined.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "put_assembly.hpp"
#include "roomatlas/asr/joined_source.hpp"
#include "roomatlas/asr/load.hpp"
#include "roomatlas/loops/visit_graph.hpp"
#include "roomatlas/pipeline/mission_map.hpp"
#include "strategies.hpp"

namespace roomatlas {
namespace {

/// A store as it is matched with others.
struct Candidate {
  std::size_t store = 0;  ///< index of those given
  MissionMap map;         ///< given away once all are in order
  SensorKind sensor = SensorKind::laser;
  bool is_joined = false;  ///< of several missions already
  bool is_known = false;   ///< people know the building in its frame
  std::size_t walls = 0;   ///< wall points: how much was seen
  AsrId offset = 0;        ///< what its visits' numbers are raised by
};

/// What a laser's mission measured between its visits.
std::vector<OwnMeasurement> measured_of(const AssemblyStore& store, const Options& options) {
  const PoseGraph graph = pose_graph_of(build_graph(load(store, AsrDetail::path)), store.closures(),
                                        options.assemble.correct);
  const auto id = [&](std::int32_t node) { return graph.ids[static_cast<std::size_t>(node)]; };
  std::vector<OwnMeasurement> measured;
  for (const PoseEdge& edge : graph.edges) {
    measured.push_back({id(edge.from), id(edge.to), edge.from_from_to, edge.information,
                        edge.kind == EdgeKind::loop});
  }
  return measured;
}

/// @throws InputError where it is not of the visits that the store has
Placement other_answer_of(const AssemblyStore& store, const Placement& placement) {
  Placement other = store.other_answer();
  const auto is_of_one_visit = [](const auto& a, const auto& b) { return a.first == b.first; };
  const bool is_whole =
      std::equal(other.begin(), other.end(), placement.begin(), placement.end(), is_of_one_visit);
  if (other.empty() || is_whole) return other;
  throw InputError(store.mission().file +
                   ": metadata.other_answer_json does not hold the visits of the mission; run "
                   "`roomatlas assemble` again");
}

Candidate candidate_of(std::size_t index, const AssemblyStore& store, const Options& options) {
  if (!store.has_assembly()) {
    throw InputError(store.mission().file + ": not assembled; run `roomatlas assemble` first");
  }
  Candidate candidate;
  candidate.store = index;
  candidate.is_joined = store.members().size() > 1;
  candidate.map = mission_map_of(store, placement_of(store.correction()), options);
  candidate.sensor = candidate.map.sensor;
  for (const AsrShape& shape : candidate.map.shapes) candidate.walls += shape.points.size();
  if (candidate.sensor == SensorKind::laser && !candidate.is_joined) {
    candidate.map.measured = measured_of(store, options);
    candidate.map.other_answer = other_answer_of(store, candidate.map.mission_from_asr);
  }
  return candidate;
}

/// Where what the missions are decides, and not where they stand on the command line.
bool is_before(const Candidate& a, const Candidate& b) {
  const auto key = [](const Candidate& one) {
    const Point2 first = one.map.shapes.empty() || one.map.shapes[0].points.empty()
                             ? Point2::Zero()
                             : one.map.shapes[0].points[0].position;
    return std::tuple(!one.is_joined, one.sensor == SensorKind::sonar,
                      !one.map.other_answer.empty(),  // which of two is true the others say
                      !one.is_known, std::numeric_limits<std::size_t>::max() - one.walls, first.x(),
                      first.y());
  };
  return key(a) < key(b);
}

Placement renumbered(const Placement& placement, AsrId offset) {
  Placement raised;
  for (const auto& [id, pose] : placement) raised[id + offset] = pose;
  return raised;
}

void renumber(MissionMap& map, AsrId offset) {
  map.mission_from_asr = renumbered(map.mission_from_asr, offset);
  map.other_answer = renumbered(map.other_answer, offset);
  for (AsrShape& shape : map.shapes) shape.id += offset;
  decltype(map.rays) rays;
  for (auto& [id, of_visit] : map.rays) rays[id + offset] = std::move(of_visit);
  map.rays = std::move(rays);
  for (OwnMeasurement& one : map.measured) {
    one.from += offset;
    one.to += offset;
  }
}

Closure renumbered(Closure closure, const std::map<AsrId, AsrId>& number) {
  closure.from = number.at(closure.from);
  closure.to = number.at(closure.to);
  return closure;
}

MemberMission member_of(const AssemblyStore& store, const JoinedMission& joined,
                        SensorKind sensor) {
  MemberMission member;
  member.name = store.mission().file;
  member.sensor = sensor;
  member.is_base = joined.is_base;
  member.score = joined.best.score;
  member.runner_up_score = joined.runner_up_score;
  member.agreement = joined.best.agreement();
  member.pieces = static_cast<int>(joined.best.pieces.size());
  member.pieces_fitting = static_cast<int>(joined.best.fitting());
  return member;
}

/// Which of the members are drawn: those that are named, by name or number, or all.
std::vector<bool> drawn_of(const std::vector<MemberMission>& members,
                           const std::vector<std::string>& named) {
  std::vector<bool> drawn(members.size(), named.empty());
  for (const std::string& name : named) drawn[index_of(members, name)] = true;
  return drawn;
}

/// Visits from which nothing is drawn: of missions that were not asked for, and of sonars where
/// lasers saw the building.
/// @returns whether lasers are drawn
bool leave_out(const std::vector<MemberMission>& members, const std::vector<std::string>& named,
               std::set<AsrId>& not_drawn) {
  const std::vector<bool> drawn = drawn_of(members, named);
  bool has_laser = false;
  for (std::size_t i = 0; i < members.size(); ++i) {
    has_laser = has_laser || (drawn[i] && members[i].sensor == SensorKind::laser);
  }
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (drawn[i] && (!has_laser || members[i].sensor == SensorKind::laser)) continue;
    for (AsrId id = members[i].first_asr; id <= members[i].last_asr; ++id) not_drawn.insert(id);
  }
  return has_laser;
}

/// Readings of lasers matched once more where the missions lie now, with all that lies on them.
Paths fed_back(const AsrSource& source, const CorrectedMission& corrected, const Options& options) {
  const SelectedAsrs lasers = without(source, corrected.not_drawn);
  return feed_back(lasers, shapes_of(lasers, options), corrected.closures,
                   placement_of(corrected.correction), options.assemble.feed_back, options.jobs);
}

/// Takes a store's missions and visits into a building, with the numbers that follow.
class BuildingMaker {
 public:
  explicit BuildingMaker(const JoinedMissions& joined) : joined_(joined) {}

  void add(const Candidate& candidate, const AssemblyStore& store, const JoinedMission& mission) {
    building_.missions.push_back(candidate.store);
    if (mission.is_other_answer) building_.answered_otherwise.push_back(candidate.store);
    if (mission.is_base) building_.verdict = mission.verdict;
    const AsrId offset = last_;
    std::map<AsrId, AsrId> own;
    const std::vector<AsrId> ids = store.ids();
    for (const AsrId id : ids) {
      own[id] = id + offset;
      number_[id + candidate.offset] = id + offset;
      building_.placement[id + offset] = joined_.placement.at(id + candidate.offset);
    }
    last_ += ids.empty() ? 0 : ids.back();
    for (const Closure& closure : store.closures()) {
      building_.closures.push_back(renumbered(closure, own));
    }
    std::vector<MemberMission> members = store.members();
    if (members.empty()) {
      members.push_back(member_of(store, mission, candidate.sensor));
      members.back().true_poses = std::ssize(store.truth());
      members.back().first_asr = ids.empty() ? 1 : ids.front();
      members.back().last_asr = ids.empty() ? 0 : ids.back();
    }
    for (MemberMission& member : members) {
      member.first_asr += offset;
      member.last_asr += offset;
      building_.members.push_back(std::move(member));
    }
  }

  JoinedBuilding made() {
    for (const Closure& closure : joined_.closures) {
      if (number_.contains(closure.from)) {
        building_.closures.push_back(renumbered(closure, number_));
      }
    }
    return std::move(building_);
  }

 private:
  const JoinedMissions& joined_;
  JoinedBuilding building_;
  AsrId last_ = 0;
  std::map<AsrId, AsrId> number_;  ///< in the building, of each visit in `joined_`
};

}  // namespace

std::vector<JoinedBuilding> join_stores(const std::vector<const AssemblyStore*>& stores,
                                        const Options& options, const Progress& progress,
                                        const Workers& workers, std::optional<std::size_t> base) {
  std::vector<Candidate> candidates;
  candidates.reserve(stores.size());
  for (std::size_t i = 0; i < stores.size(); ++i) {
    report(progress, "load", static_cast<double>(i) / static_cast<double>(stores.size()));
    candidates.push_back(candidate_of(i, *stores[i], options));
    candidates.back().is_known = base == i;
  }
  std::stable_sort(candidates.begin(), candidates.end(), is_before);
  AsrId offset = 0;
  std::vector<MissionMap> maps;
  maps.reserve(candidates.size());
  for (Candidate& candidate : candidates) {
    candidate.offset = offset;
    renumber(candidate.map, offset);
    if (!candidate.map.shapes.empty()) offset = candidate.map.shapes.back().id;
    maps.push_back(std::move(candidate.map));
  }
  const JoinedMissions joined = join_missions(maps, options.join, progress, workers);
  std::map<int, BuildingMaker> makers;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const JoinedMission& mission = joined.missions[i];
    makers.try_emplace(mission.component, joined)
        .first->second.add(candidates[i], *stores[candidates[i].store], mission);
  }
  std::vector<JoinedBuilding> buildings;
  buildings.reserve(makers.size());
  for (auto& [component, maker] : makers) buildings.push_back(maker.made());
  std::stable_sort(buildings.begin(), buildings.end(),
                   [](const JoinedBuilding& a, const JoinedBuilding& b) {
                     return a.members.size() > b.members.size();
                   });
  return buildings;
}

Assembly assemble_joined(AssemblyStore& store, const JoinedBuilding& building,
                         const Options& options, const std::string& configuration,
                         const Progress& progress) {
  const std::vector<Asr> asrs = load(store, AsrDetail::path);
  CorrectedMission corrected;
  corrected.are_rooms_matched = true;
  corrected.are_edits_heard = false;
  corrected.graph = build_graph(asrs);
  for (const Closure& closure : building.closures) {
    if (closure.verdict == ClosureVerdict::accepted) add_edge(corrected.graph, edge_of(closure));
  }
  corrected.closures = building.closures;
  // The frame is that of the base, whose walls lie along the axes: turned anew by what is left
  // over, the building would move whenever it is assembled, and statements by hand with it.
  constexpr double kWalls_rad = 0.0;
  corrected.correction =
      correct_to(asrs, corrected.graph, building.placement, options.assemble.correct, kWalls_rad);
  corrected.correction.model = "joined";
  corrected.correction.message = "placed by matching several missions";
  const bool has_laser =
      leave_out(building.members, options.assemble.missions, corrected.not_drawn);
  if (has_laser && options.assemble.draw_latest) {
    corrected.times = in_order_of_time(asrs, building.members, corrected.not_drawn);
  }
  if (has_laser && options.assemble.feed_back.enabled) {
    report(progress, "match readings", -1.0);
    corrected.paths = fed_back(store, corrected, options);
  }
  Assembly assembly =
      assemble_corrected(has_laser ? MissionKind::laser : MissionKind::sonar, store,
                         std::move(corrected), store.mission().footprint, options, progress);
  put_with_former_rooms(store, configuration, assembly);
  return assembly;
}

}  // namespace roomatlas
