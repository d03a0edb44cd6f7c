// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/trust/map_figures.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "driven_odometry.hpp"
#include "moved_visits.hpp"
#include "roomatlas/asr/shared_source.hpp"
#include "roomatlas/core/for_each_index.hpp"
#include "roomatlas/graph/bridges.hpp"

namespace roomatlas {
namespace {

/// A small positive figure on a scale of its own size.
double log_of(double value, double least) { return std::log(std::max(value, least)); }

/// What all figures are made from; readings are read once.
struct Measured {
  std::vector<VisitAgreement> agreement;
  std::map<AsrId, Point2> centres;  ///< of the visits' paths, in their frames
  OdometryUse odometry;
  double hits_a_reading = 0.0;
  bool has_readings = false;
};

/// What one visit gives; its readings are gone then.
struct VisitMeasured {
  AsrEvidence evidence;
  std::vector<PathSample> path;
  std::size_t readings = 0;
  std::ptrdiff_t hits = 0;
};

Point2 centre_of(const std::vector<PathSample>& path) {
  Point2 sum = Point2::Zero();
  for (const PathSample& sample : path) sum += sample.asr_from_robot.position();
  return sum / std::max(1.0, static_cast<double>(path.size()));
}

VisitMeasured measure(Asr asr, const EvidenceOptions& options) {
  VisitMeasured visit{evidence_of(asr, options), std::move(asr.path), asr.readings.size(), 0};
  for (const RangeReading& reading : asr.readings) {
    visit.hits += std::count_if(
        reading.ranges_m.begin(), reading.ranges_m.end(),
        [&](float range_m) { return range_m > 0.0F && range_m < reading.sensor->max_range_m; });
  }
  return visit;
}

Measured measure(const AsrSource& source, const Assembly& assembly, int jobs) {
  ConsistencyOptions options;
  options.jobs = jobs;
  const std::vector<AsrId> ids = source.ids();
  const SharedSource shared(source);
  auto visits = results_of<VisitMeasured>(ids.size(), jobs, [&](std::size_t i) {
    return measure(shared.get(ids[i], AsrDetail::readings), options.evidence);
  });
  Measured measured;
  std::vector<AsrEvidence> evidence;
  evidence.reserve(visits.size());
  std::size_t readings = 0;
  std::ptrdiff_t hits = 0;
  for (std::size_t i = 0; i < visits.size(); ++i) {
    evidence.push_back(std::move(visits[i].evidence));
    measured.odometry.add(visits[i].path);
    measured.centres[ids[i]] = centre_of(visits[i].path);
    readings += visits[i].readings;
    hits += visits[i].hits;
  }
  measured.has_readings = readings > 0;
  measured.hits_a_reading =
      static_cast<double>(hits) / std::max(1.0, static_cast<double>(readings));
  measured.agreement = visit_agreement(evidence, placement_of(assembly.correction), options);
  return measured;
}

struct Agreement {
  double known_share = 0.0;
  double free_share = 0.0;
  double apart_m = 0.0;
};

constexpr double kFewHits = 30.0;  // so many hits without a finding are believed as much as those
                                   // that are asked about

Agreement agreement_of(const VisitAgreement& sums) {
  const auto share = [](double part, double all) { return part / (all + kFewHits); };
  return {share(static_cast<double>(sums.known), static_cast<double>(sums.hits)),
          share(static_cast<double>(sums.in_free_space), static_cast<double>(sums.seen)),
          share(sums.apart_m, static_cast<double>(sums.compared))};
}

VisitAgreement sum_of(const std::vector<VisitAgreement>& visits) {
  VisitAgreement sum;
  for (const VisitAgreement& visit : visits) {
    sum.hits += visit.hits;
    sum.known += visit.known;
    sum.seen += visit.seen;
    sum.in_free_space += visit.in_free_space;
    sum.compared += visit.compared;
    sum.apart_m += visit.apart_m;
  }
  return sum;
}

/// Of the visit whose hits the others contradict most.
double worst_free_share(const std::vector<VisitAgreement>& visits) {
  double worst = 0.0;
  for (const VisitAgreement& visit : visits) {
    worst = std::max(worst, agreement_of(visit).free_share);
  }
  return worst;
}

std::vector<JudgedFigure> common_figures(const Measured& measured, const Assembly& assembly) {
  const Agreement all = agreement_of(sum_of(measured.agreement));
  const OdometryUse::Differences odometry = measured.odometry.differences();
  return {
      {"path", log_of(measured.odometry.path_m(), 1.0)},
      {"visits", log_of(static_cast<double>(assembly.correction.asrs.size()), 1.0)},
      {"echoes a reading", log_of(measured.hits_a_reading, 0.1)},
      {"seen again", all.known_share},
      {"hits in free space", log_of(all.free_share, 0.001)},
      {"worst visit's hits in free space", log_of(worst_free_share(measured.agreement), 0.001)},
      {"doubled walls", log_of(all.apart_m, 0.002)},
      {"odometry's headings against the map's", log_of(odometry.heading_rad_per_m, 0.001)},
      {"odometry's lengths against the map's", log_of(odometry.length_share, 0.001)},
      {"odometry's steady drift", log_of(std::abs(odometry.drift_rad_per_m), 0.0005)},
  };
}

/// Of a correction by measurements between visits.
void add_loops(const Assembly& assembly, const VisitUncertainty& uncertainty,
               std::vector<JudgedFigure>& figures) {
  const RoomGraph& graph = assembly.graph;
  const double visits = std::max<double>(1.0, static_cast<double>(graph.vertices.size()));
  std::size_t hanging = 0;
  for (const Bridge& bridge : bridges_of(graph)) hanging = std::max(hanging, bridge.behind);
  double largest_m2 = 0.0;
  double largest_rad = 0.0;
  for (const VisitEstimate& visit : uncertainty.visits) {
    largest_rad = std::max(largest_rad, visit.heading_sigma_rad);
    largest_m2 = std::max(
        largest_m2,
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(visit.covariance_m2).eigenvalues()[1]);
  }
  double tried = 0.0, accepted = 0.0, agreeing = 0.0, contradicting = 0.0;
  for (const Closure& closure : assembly.closures) {
    tried += 1.0;
    if (closure.verdict != ClosureVerdict::accepted) continue;
    accepted += 1.0;
    agreeing += closure.match.agreeing;
    contradicting += closure.match.contradicting;
  }
  double doubtful = 0.0;
  for (const PassageEdge& edge : graph.edges) doubtful += edge.is_doubtful ? 1.0 : 0.0;
  figures.insert(figures.end(),
                 {{"loops a visit", std::log1p(accepted / visits)},
                  {"matches accepted", accepted / (tried + 1.0)},
                  {"contradiction in matches",
                   log_of(contradicting / (agreeing + contradicting + 1.0), 0.001)},
                  {"strain of loops", log_of(std::sqrt(uncertainty.variance_factor), 0.1)},
                  {"place of a visit", log_of(uncertainty.typical_m.value_or(0.0), 0.001)},
                  {"place of the loosest visit", log_of(std::sqrt(largest_m2), 0.001)},
                  {"heading of the loosest visit", log_of(largest_rad, 0.0005)},
                  {"passages in which the robot was lost", std::log1p(doubtful)},
                  {"visits on one passage", static_cast<double>(hanging) / visits}});
}

/// Of a visit; none where there is no such solution.
MoveSize size_in(const MapMoves& moves, AsrId asr) {
  const auto found = moves.visits.find(asr);
  return found == moves.visits.end() ? MoveSize{} : found->second;
}

/// How loosely walls and odometry hold the visits of sonars, and what they say against each other.
void add_moves(const VisitMoves& moved, const std::map<AsrId, Point2>& centres,
               MapFigures& result) {
  const MapMoves drawn = map_moves(moved.drawn, centres);
  const MapMoves wild = map_moves(moved.wild, centres);
  const auto moves_if_any = [&](const MovedVisits& visits) {
    return visits.empty() ? MapMoves{} : map_moves(visits, centres);
  };
  const MapMoves undirected = moves_if_any(moved.undirected);
  const MapMoves otherwise = moves_if_any(moved.cross_check);
  const auto log_m = [](double place_m) { return log_of(place_m, 0.001); };
  const auto log_rad = [](double heading_rad) { return log_of(heading_rad, 0.0005); };
  result.figures.insert(
      result.figures.end(),
      {{"place of a visit", log_m(drawn.place_m)},
       {"place of the loosest visit", log_m(drawn.worst.place_m)},
       {"heading of the loosest visit", log_rad(drawn.worst.heading_rad)},
       {"visits held loosely", drawn.log_off},
       {"place by contradictions", log_m(wild.place_m)},
       {"most a place is pulled by contradictions", log_m(wild.worst.place_m)},
       {"most a heading is pulled by contradictions", log_rad(wild.worst.heading_rad)},
       {"visits pulled by contradictions", wild.log_off},
       {"turned by directions", log_rad(undirected.worst.heading_rad)},
       {"turned when solved otherwise", log_rad(otherwise.worst.heading_rad)},
       {"visits moved when solved otherwise", otherwise.log_off}});
  for (VisitJudgement& visit : result.visits) {
    const MoveSize& held = drawn.visits.at(visit.asr);
    const MoveSize& pulled = wild.visits.at(visit.asr);
    const MoveSize turned = size_in(undirected, visit.asr);
    const MoveSize other = size_in(otherwise, visit.asr);
    visit.figures.insert(visit.figures.end(),
                         {{"place", log_m(held.place_m)},
                          {"heading", log_rad(held.heading_rad)},
                          {"place by contradictions", log_m(pulled.place_m)},
                          {"heading by contradictions", log_rad(pulled.heading_rad)},
                          {"turned by directions", log_rad(turned.heading_rad)},
                          {"place when solved otherwise", log_m(other.place_m)},
                          {"turned when solved otherwise", log_rad(other.heading_rad)}});
  }
}

/// Of a correction as one trajectory by walls that sonars heard.
void add_sonars(const SonarTrajectory& sonars, double path_m, std::vector<JudgedFigure>& figures) {
  const SonarVariant chosen =
      sonars.variants.empty() ? SonarVariant{} : sonars.variants.at(sonars.chosen);
  const double metres = std::max(1.0, path_m);
  figures.insert(
      figures.end(),
      {{"contradiction of walls", log_of(chosen.contradiction, 0.005)},
       {"wall heard again", std::log1p(chosen.compared_m / metres)},
       {"stretches of wall a metre", log_of(static_cast<double>(sonars.segments) / metres, 0.01)},
       {"pairs of stretches", std::log1p(static_cast<double>(chosen.pairs) /
                                         std::max(1.0, static_cast<double>(sonars.segments)))},
       {"directions of the building", static_cast<double>(sonars.wall_directions_rad.size())},
       {"unsure heading", log_of(1.0 - sonars.sure_heading_share, 0.005)},
       {"undecided drives", log_of(sonars.undecided_m / metres, 0.001)},
       {"score of another winding", sonars.rival_score},
       {"strain of odometry", log_of(sonars.strain / metres, 0.001)},
       {"attempts apart", log_of(sonars.attempts_apart_m, 0.005)},
       {"merit over the map solved otherwise", sonars.cross_check.merit_share},
       {"walls in directions", sonars.followed_share},
       {"attempts turned apart", log_of(sonars.headings_apart_rad, 0.0005)},
       {"slips repaired", std::log1p(sonars.slips_repaired)},
       {"uncertainty of the scale", log_of(sonars.length_scale_sigma, 0.0005)},
       {"clutter before walls", log_of(sonars.clutter_m, 0.001)},
       {"odometry's bias", log_of(std::abs(sonars.habits.bias_rad_per_m), 0.0005)},
       {"odometry's gain", log_of(std::abs(sonars.habits.turn_gain - 1.0), 0.002)}});
}

/// What others saw of each visit's walls and floor.
std::vector<VisitJudgement> visits_of(const Measured& measured, const Assembly& assembly) {
  std::vector<VisitJudgement> visits;
  for (const VisitAgreement& sums : measured.agreement) {
    const Agreement agreement = agreement_of(sums);
    const auto room = assembly.room_of_asr.find(sums.asr);
    visits.push_back({sums.asr,
                      room == assembly.room_of_asr.end() ? 0 : room->second,
                      0.0,
                      0.0,
                      {{"seen again", agreement.known_share},
                       {"hits in free space", log_of(agreement.free_share, 0.001)},
                       {"doubled walls", log_of(agreement.apart_m, 0.002)}}});
  }
  return visits;
}

/// How measurements hold each visit.
void add_holding(const Assembly& assembly, const VisitUncertainty& uncertainty,
                 std::vector<VisitJudgement>& visits) {
  std::map<AsrId, double> place_m;
  for (const VisitEstimate& visit : uncertainty.visits) {
    place_m[visit.asr] = std::sqrt(visit.covariance_m2.trace() / 2.0);
  }
  std::map<AsrId, int> loops;
  for (const Closure& closure : assembly.closures) {
    if (closure.verdict != ClosureVerdict::accepted) continue;
    ++loops[closure.from];
    ++loops[closure.to];
  }
  for (VisitJudgement& visit : visits) {
    visit.figures.push_back({"place", log_of(place_m[visit.asr], 0.001)});
    visit.figures.push_back({"loops", std::log1p(loops[visit.asr])});
  }
}

}  // namespace

MapFigures map_figures(const AsrSource& source, const Assembly& assembly,
                       const CorrectOptions& correct, int jobs) {
  MapFigures result;
  if (assembly.correction.asrs.empty()) return result;
  const Measured measured = measure(source, assembly, jobs);
  if (!measured.has_readings) return result;
  result.sensor = assembly.sonars ? SensorKind::sonar : SensorKind::laser;
  result.figures = common_figures(measured, assembly);
  result.visits = visits_of(measured, assembly);
  if (assembly.sonars) {
    add_sonars(*assembly.sonars, measured.odometry.path_m(), result.figures);
    add_moves(assembly.moves, measured.centres, result);
  } else {
    const VisitUncertainty uncertainty =
        uncertainty_of(assembly.graph, assembly.closures, assembly.correction, correct);
    add_loops(assembly, uncertainty, result.figures);
    add_holding(assembly, uncertainty, result.visits);
  }
  return result;
}

}  // namespace roomatlas
