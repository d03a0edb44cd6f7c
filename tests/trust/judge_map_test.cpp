// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/trust/judge_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "learnt_model.hpp"
#include "pipeline/three_rounds.hpp"
#include "roomatlas/io/results/judgement_json.hpp"
#include "roomatlas/pipeline/assemble.hpp"

namespace roomatlas {
namespace {

/// Figures of a mission as those that were learnt from had them in the mean, each moved by so many
/// deviations towards what speaks against the map.
MapFigures figures_of(SensorKind sensor, double deviations) {
  MapFigures figures;
  figures.sensor = sensor;
  for (const LearntTerm& term : model_of(sensor).right.terms) {
    const double sign = term.weight > 0.0 ? -1.0 : 1.0;
    figures.figures.push_back({term.name, term.mean + sign * deviations * term.deviation});
  }
  return figures;
}

class OfASensor : public testing::TestWithParam<SensorKind> {};
INSTANTIATE_TEST_SUITE_P(Each, OfASensor, testing::Values(SensorKind::laser, SensorKind::sonar));

TEST_P(OfASensor, WhatSpeaksAgainstTheMapLowersItsProbabilityAndIsNamed) {
  double last = 1.0;
  for (const double deviations : {-2.0, -1.0, 0.0, 1.0, 2.0}) {
    const Judgement judgement = judge_map(figures_of(GetParam(), deviations), {}).value();
    EXPECT_LT(judgement.probability, last);
    last = judgement.probability;
  }
  EXPECT_TRUE(judge_map(figures_of(GetParam(), -2.0), {})->doubts.empty());
  const Judgement bad = judge_map(figures_of(GetParam(), 2.0), {}).value();
  ASSERT_FALSE(bad.doubts.empty());
  EXPECT_TRUE(std::is_sorted(bad.doubts.begin(), bad.doubts.end(),
                             [](const Doubt& a, const Doubt& b) { return a.weight > b.weight; }));
  std::set<std::string> texts;
  for (const Doubt& doubt : bad.doubts) EXPECT_TRUE(texts.insert(doubt.text).second) << doubt.text;
}

TEST_P(OfASensor, TheProbabilityIsTheLogisticFunctionOfTheSumOfItsPartsButForLapses) {
  double sum = model_of(GetParam()).right.bias;
  for (const LearntTerm& term : model_of(GetParam()).right.terms) {
    sum -= 0.7 * std::abs(term.weight);
  }
  const double known = 1.0 - model_of(GetParam()).lapses;
  EXPECT_NEAR(judge_map(figures_of(GetParam(), 0.7), {})->probability,
              known / (1.0 + std::exp(-sum)), 1e-9);
  EXPECT_LE(judge_map(figures_of(GetParam(), -9.0), {})->probability, known);
}

TEST_P(OfASensor, NoHeadingIsOffByMoreThanHalfATurn) {
  MapFigures figures = figures_of(GetParam(), 0.0);
  for (const LearntTerm& term : model_of(GetParam()).heading.terms) {
    for (JudgedFigure& figure : figures.figures) {
      const double sign = term.weight > 0.0 ? 1.0 : -1.0;
      if (figure.name == term.name) figure.value = term.mean + sign * 3.0 * term.deviation;
    }
  }
  EXPECT_EQ(judge_map(figures, {})->heading_deg, 180.0);
}

TEST_P(OfASensor, FiguresBeyondWhatWasLearntCountAsTheLastThatWere) {
  EXPECT_EQ(judge_map(figures_of(GetParam(), 4.0), {})->probability,
            judge_map(figures_of(GetParam(), 30.0), {})->probability);
}

TEST_P(OfASensor, WhatWasDoubtedOnceCountsAsMuchAsWhatIsSaidNow) {
  const MapFigures figures = figures_of(GetParam(), -1.0);
  const double now = judge_map(figures, {})->probability;
  Assembly again;
  again.doubted = 0.2;
  const Judgement judgement = judge_map(figures, again).value();
  EXPECT_GT(now, 0.5);
  EXPECT_NEAR(judgement.probability / (1.0 - judgement.probability),
              std::sqrt(now / (1.0 - now) * 0.2 / 0.8), 1e-9);
  ASSERT_FALSE(judgement.doubts.empty());
  EXPECT_NE(judgement.doubts.back().text.find("was doubted"), std::string::npos);
}

TEST(JudgeMap, WithoutFiguresNothingIsSaid) { EXPECT_FALSE(judge_map({}, {})); }

/// Mapped and assembled once for all tests.
const Assembly& simulated() {
  static const Assembly assembly =
      assemble(test::mapped(test::three_rounds(OdometryPreset::typical)), {}, {});
  return assembly;
}

TEST(JudgeMap, ASimulatedMissionIsJudgedAndItsRoomsAreAsGoodAsTheirWorstVisit) {
  ASSERT_TRUE(simulated().judgement);
  const Judgement& judgement = *simulated().judgement;
  EXPECT_GT(judgement.probability, 0.5);
  EXPECT_EQ(judgement.visits.size(), simulated().correction.asrs.size());
  ASSERT_FALSE(judgement.rooms.empty());
  for (const RoomJudgement& room : judgement.rooms) {
    double worst = 1.0;
    for (const VisitJudgement& visit : judgement.visits) {
      if (visit.room == room.room) worst = std::min(worst, visit.probability);
    }
    EXPECT_EQ(room.probability, worst);
  }
}

TEST(JudgeMap, RoomsWithOtherNumbersAreJudgedAlike) {
  Assembly assembly = simulated();
  for (auto& [asr, room] : assembly.room_of_asr) room += 100;
  const Judgement renumbered = judged_anew(*assembly.judgement, assembly);
  ASSERT_EQ(renumbered.rooms.size(), assembly.judgement->rooms.size());
  for (std::size_t i = 0; i < renumbered.rooms.size(); ++i) {
    EXPECT_EQ(renumbered.rooms[i].room, assembly.judgement->rooms[i].room + 100);
    EXPECT_EQ(renumbered.rooms[i].probability, assembly.judgement->rooms[i].probability);
  }
  EXPECT_EQ(renumbered.probability, assembly.judgement->probability);
}

TEST(JudgeMap, AnEarlierReleasesFiguresKeepWhatWasSaid) {
  Assembly assembly = simulated();
  for (auto& [asr, room] : assembly.room_of_asr) room += 100;
  Judgement earlier = *assembly.judgement;
  earlier.figures.erase(earlier.figures.begin(), earlier.figures.begin() + 5);
  earlier.probability = 0.625;
  const Judgement renumbered = judged_anew(earlier, assembly);
  EXPECT_EQ(renumbered.probability, 0.625);
  ASSERT_EQ(renumbered.rooms.size(), earlier.rooms.size());
  EXPECT_EQ(renumbered.rooms[0].room, earlier.rooms[0].room + 100);
}

Advice advice_between(AsrId from, AsrId to) {
  Advice advice;
  advice.kind = AdviceKind::use_door;
  advice.from = from;
  advice.to = to;
  advice.from_room = from;
  advice.to_room = to;
  advice.by_door = true;
  advice.drive_m = 12.5;
  advice.place_before_m = 0.5;
  advice.place_after_m = 0.25;
  return advice;
}

TEST(JudgeMap, AdviceIsForDoubtfulMapsAndGetsTheRoomsNewNumbers) {
  Judgement judgement = judge_map(figures_of(SensorKind::laser, -2.0), {}).value();
  ASSERT_GE(judgement.probability, kTrusted);
  advise({}, {}, judgement);
  EXPECT_TRUE(judgement.advice.empty());
  judgement.advice = {advice_between(1, 2)};
  Assembly renumbered;
  renumbered.room_of_asr = {{1, 101}, {2, 102}};
  const Judgement after = judged_anew(judgement, renumbered);
  ASSERT_EQ(after.advice.size(), 1U);
  EXPECT_EQ(after.advice[0].from_room, 101);
  EXPECT_EQ(after.advice[0].to_room, 102);
}

TEST(JudgeMap, ItsTextReadsBackTheSame) {
  Judgement judgement = *simulated().judgement;
  judgement.advice = {advice_between(1, 2)};
  const std::string text = to_json(judgement);
  const Judgement read = judgement_of(text).value();
  EXPECT_EQ(to_json(read), text);
  EXPECT_EQ(judged_anew(read, simulated()).probability, simulated().judgement->probability);
  EXPECT_FALSE(judgement_of(""));
  EXPECT_THROW((void)judgement_of("{\"probability\": 1}"), InputError);
  EXPECT_THROW((void)judgement_of("half a te"), InputError);
}

}  // namespace
}  // namespace roomatlas
