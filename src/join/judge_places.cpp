// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/join/judge_places.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "learnt_places.hpp"
#include "roomatlas/grid/cells.hpp"

namespace roomatlas {
namespace {

struct Tally {
  int agree = 0;
  int contradict = 0;
  int nothing = 0;
};

Tally tally_of(const std::vector<Told>& told) {
  const auto count = [&](Told what) {
    return static_cast<int>(std::count(told.begin(), told.end(), what));
  };
  return {count(Told::agrees), count(Told::contradicts), count(Told::nothing)};
}

/// Where walls, floor and ends of rays lie in the mission, cell by cell, in the order of
/// `PlaceEvidence`.
struct Cells {
  std::vector<Cell> walls;
  std::vector<Cell> floor;
  std::vector<Cell> rays;
};

Cells cells_of(const std::vector<AskedVisit>& asked, const CellFrame& frame) {
  Cells cells;
  for (const AskedVisit& visit : asked) {
    const PointTransform to(visit.mission_from_asr);
    for (const ScanPoint& wall : visit.sketch.walls) {
      cells.walls.push_back(frame.cell_of(to * wall.position));
    }
    for (const Point2& at : visit.sketch.floor) cells.floor.push_back(frame.cell_of(to * at));
    for (const QueryRay& ray : visit.rays) {
      cells.rays.push_back(frame.cell_of(to * (ray.query_from_beam * Point2{ray.range_m, 0.0})));
    }
  }
  return cells;
}

/// In how many cells more agrees at one place and contradicts at another than the reverse, and
/// in how many it is the reverse.
struct Votes {
  int one = 0;
  int other = 0;
};

Votes votes_between(const std::vector<Told>& one, const std::vector<Told>& other,
                    const std::vector<Cell>& cells) {
  std::map<std::pair<int, int>, int> for_one;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (one[i] == other[i] || one[i] == Told::nothing || other[i] == Told::nothing) continue;
    for_one[{cells[i].y, cells[i].x}] += one[i] == Told::agrees ? 1 : -1;
  }
  Votes votes;
  for (const auto& [cell, balance] : for_one) {
    votes.one += balance > 0 ? 1 : 0;
    votes.other += balance < 0 ? 1 : 0;
  }
  return votes;
}

/// Floor says less than walls and rays do: half a cell of it is often wall.
constexpr double kFloorVote = 0.5;

/// How clearly votes are for the first place: their excess in units of its scatter, were they drawn
/// by lot.
double clear_votes(const PlaceEvidence& first, const PlaceEvidence& rival, const Cells& cells) {
  const Votes walls = votes_between(first.walls, rival.walls, cells.walls);
  const Votes floor = votes_between(first.floor, rival.floor, cells.floor);
  const Votes rays = votes_between(first.rays, rival.rays, cells.rays);
  const double for_first = walls.one + kFloorVote * floor.one + rays.one;
  const double for_rival = walls.other + kFloorVote * floor.other + rays.other;
  return (for_first - for_rival) / std::sqrt(for_first + for_rival + 1.0);
}

// Where no other place is near, votes and margins are as clear as these.
constexpr double kClearVotes = 6.0;
constexpr double kClearMargin = 30.0;
// What a longer path scores more than this says how long it is.
constexpr double kClearScore = 100.0;

double log_share(double part, double of_all) { return std::log((part + 1.0) / (of_all + 20.0)); }

/// Of the same counts, without the bound that a share has.
double log_odds(double part, double rest) { return std::log((part + 1.0) / (rest + 19.0)); }

class PlaceJudge {
 public:
  PlaceJudge(const std::vector<AskedVisit>& asked, const SeenBuilding& building, SensorKind sensor,
             const JudgePlacesOptions& options)
      : asked_(asked), building_(building), options_(options), sensor_(sensor) {}

  JudgedPlaces judged(std::vector<MissionPlace> places) const {
    std::vector<PlaceEvidence> evidence;
    for (MissionPlace& place : places) {
      if (place.score < places[0].score - options_.near_score) break;
      evidence.push_back(evidence_at(place));
    }
    for (std::size_t i = 0; i < evidence.size(); ++i) places[i].score += ray_score(evidence[i]);
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(
        order.begin(), order.begin() + std::ssize(evidence),
        [&](std::size_t a, std::size_t b) { return places[a].score > places[b].score; });
    JudgedPlaces result;
    std::vector<PlaceEvidence> ordered;
    for (const std::size_t i : order) {
      if (i < evidence.size()) ordered.push_back(std::move(evidence[i]));
      result.places.push_back(std::move(places[i]));
    }
    if (result.places.empty()) return result;
    result.figures = figures_of(result.places, ordered);
    const LearntSum& learnt =
        sensor_ == SensorKind::laser ? laser_place_is_right() : sonar_place_is_right();
    result.first_is_right = 1.0 / (1.0 + std::exp(-sum_of(learnt, result.figures)));
    return result;
  }

 private:
  [[nodiscard]] PlaceEvidence evidence_at(const MissionPlace& place) const {
    const std::map<AsrId, Pose2> building_from_mission = place.building_from_mission_by_visit();
    PlaceEvidence evidence;
    for (const AskedVisit& visit : asked_) {
      add_evidence(visit, building_, building_from_mission.at(visit.id) * visit.mission_from_asr,
                   options_.evidence, evidence);
    }
    return evidence;
  }

  [[nodiscard]] double ray_score(const PlaceEvidence& evidence) const {
    const Tally rays = tally_of(evidence.rays);
    const double nats = sensor_ == SensorKind::laser ? options_.laser_nats : options_.sonar_nats;
    return nats * (rays.agree - options_.contradiction * rays.contradict);
  }

  [[nodiscard]] std::vector<JudgedFigure> figures_of(
      const std::vector<MissionPlace>& places, const std::vector<PlaceEvidence>& evidence) const {
    const Tally walls = tally_of(evidence[0].walls);
    const Tally rays = tally_of(evidence[0].rays);
    const int against = walls.contradict + tally_of(evidence[0].floor).contradict;
    const int all_walls = walls.agree + walls.contradict + walls.nothing;
    const int all_rays = rays.agree + rays.contradict + rays.nothing;
    double votes = kClearVotes;
    const Cells cells = cells_of(asked_, CellFrame{options_.cell_m});
    for (std::size_t i = 1; i < evidence.size(); ++i) {
      votes = std::min(votes, clear_votes(evidence[0], evidence[i], cells));
    }
    const double margin = evidence.size() < 2 ? kClearMargin : places[0].score - places[1].score;
    return {{"walls and floor that contradict", log_share(against, walls.agree + against)},
            {"walls where nothing is known", log_share(walls.nothing, all_walls)},
            {"score", std::log1p(std::clamp(places[0].score, 0.0, kClearScore))},
            {"rays that contradict", log_share(rays.contradict, rays.agree + rays.contradict)},
            {"contradicting rays to agreeing ones", log_odds(rays.contradict, rays.agree)},
            {"rays that nothing is told", log_share(rays.nothing, all_rays)},
            {"margin to the next place", std::log1p(margin)},
            {"votes against the closest rival", votes}};
  }

  const std::vector<AskedVisit>& asked_;
  const SeenBuilding& building_;
  const JudgePlacesOptions& options_;
  SensorKind sensor_;
};

}  // namespace

std::vector<AskedVisit> asked_visits(const MissionMap& mission) {
  std::vector<AskedVisit> asked;
  asked.reserve(mission.shapes.size());
  for (const AsrShape& shape : mission.shapes) {
    const AsrShape* one = &shape;
    asked.push_back({shape.id,
                     mission.mission_from_asr.at(shape.id),
                     sketch_of({&one, 1}, {{shape.id, Pose2{}}}),
                     {}});
    const auto rays = mission.rays.find(shape.id);
    if (rays != mission.rays.end()) asked.back().rays = rays->second;
  }
  return asked;
}

JudgedPlaces judge_places(std::vector<MissionPlace> places, const std::vector<AskedVisit>& asked,
                          const SeenBuilding& building, SensorKind sensor,
                          const JudgePlacesOptions& options) {
  return PlaceJudge(asked, building, sensor, options).judged(std::move(places));
}

}  // namespace roomatlas
