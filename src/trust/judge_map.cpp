// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/trust/judge_map.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "advice.hpp"
#include "doubts.hpp"
#include "learnt_model.hpp"

namespace roomatlas {
namespace {

constexpr double kAnyHeading_deg = 180.0;  // farther off no heading is

double probability_of(double log_odds) { return 1.0 / (1.0 + std::exp(-log_odds)); }

double log_odds_of(double probability) { return std::log(probability / (1.0 - probability)); }

std::vector<RoomJudgement> rooms_of(const std::vector<VisitJudgement>& visits) {
  std::map<RoomId, RoomJudgement> rooms;
  for (const VisitJudgement& visit : visits) {
    if (visit.room == 0) continue;
    auto [room, is_new] =
        rooms.try_emplace(visit.room, RoomJudgement{visit.room, visit.probability, visit.place_m});
    if (is_new) continue;
    room->second.probability = std::min(room->second.probability, visit.probability);
    room->second.place_m = std::max(room->second.place_m, visit.place_m);
  }
  std::vector<RoomJudgement> list;
  list.reserve(rooms.size());
  for (const auto& [id, room] : rooms) list.push_back(room);
  return list;
}

/// A store of an earlier release has other figures.
bool has_all(const std::vector<JudgedFigure>& figures, const LearntSum& sum) {
  return std::all_of(sum.terms.begin(), sum.terms.end(), [&](const LearntTerm& term) {
    return std::any_of(figures.begin(), figures.end(),
                       [&](const JudgedFigure& figure) { return figure.name == term.name; });
  });
}

}  // namespace

std::optional<Judgement> judge_map(const MapFigures& figures, const Assembly& assembly) {
  if (figures.figures.empty()) return std::nullopt;
  const LearntModel& model = model_of(figures.sensor);
  double log_odds = sum_of(model.right, figures.figures);
  Judgement judgement;
  judgement.probability = (1.0 - model.lapses) * probability_of(log_odds);
  if (assembly.doubted) {  // of the same drive: what was doubted once counts as much
    log_odds = (log_odds_of(judgement.probability) + log_odds_of(*assembly.doubted)) / 2.0;
    judgement.probability = probability_of(log_odds);
  }
  judgement.place_m = std::exp(sum_of(model.place, figures.figures));
  judgement.heading_deg =
      std::min(kAnyHeading_deg, std::exp(sum_of(model.heading, figures.figures)));
  judgement.scale_share = std::exp(sum_of(model.scale, figures.figures));
  judgement.figures = figures.figures;
  judgement.visits = figures.visits;
  for (VisitJudgement& visit : judgement.visits) {
    std::vector<JudgedFigure> known = visit.figures;
    known.push_back({"map", log_odds});
    visit.probability = probability_of(sum_of(model.visit_right, known));
    visit.place_m = std::exp(sum_of(model.visit_place, known));
  }
  judgement.rooms = rooms_of(judgement.visits);
  judgement.doubts = doubts_of(model.right, figures.figures, assembly);
  return judgement;
}

void advise(const Assembly& assembly, const CorrectOptions& correct, Judgement& judgement) {
  if (judgement.probability < kTrusted) judgement.advice = advice_on(assembly, correct);
}

Judgement judged_anew(const Judgement& judgement, const Assembly& assembly) {
  MapFigures figures{assembly.sonars ? SensorKind::sonar : SensorKind::laser, judgement.figures,
                     judgement.visits};
  const auto room_of = [&](AsrId asr) {
    const auto room = assembly.room_of_asr.find(asr);
    return room == assembly.room_of_asr.end() ? 0 : room->second;
  };
  for (VisitJudgement& visit : figures.visits) visit.room = room_of(visit.asr);
  Judgement anew = judgement;
  if (has_all(judgement.figures, model_of(figures.sensor).right)) {
    anew = judge_map(figures, assembly).value();
    anew.advice = judgement.advice;
  } else {
    anew.visits = figures.visits;
    anew.rooms = rooms_of(anew.visits);
  }
  for (Advice& advice : anew.advice) {
    advice.from_room = room_of(advice.from);
    advice.to_room = room_of(advice.to);
  }
  return anew;
}

}  // namespace roomatlas
