// SPDX-License-Identifier: GPL-3.0-or-later
#include "learn_trust.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "../../src/trust/learnt_model.hpp"

namespace roomatlas::bench {
namespace {

// Smaller errors are as good as none: logarithms would make much of them.
constexpr double kLeastPlace_m = 0.005;
constexpr double kLeastHeading_deg = 0.05;
constexpr double kLeastScale = 0.0005;
constexpr double kLeastOff = 0.05;
constexpr double kMostOff = 2.7;  // farther ones would matter most, and are told anyway
constexpr double kSurest = 1e-6;  // probability

using Samples = std::vector<const TrustSample*>;

Samples of_kind(const std::vector<TrustSample>& samples, SensorKind sensor) {
  Samples own;
  for (const TrustSample& sample : samples) {
    if (sample.sensor == sensor) own.push_back(&sample);
  }
  return own;
}

/// Of each mission a logarithm.
template <typename Value>
std::vector<FitRow> rows_of(const Samples& samples, Value value) {
  std::vector<FitRow> rows;
  rows.reserve(samples.size());
  for (const TrustSample* sample : samples) {
    rows.push_back({sample->figures, std::log(value(*sample)), rows.size()});
  }
  return rows;
}

/// Of each visit, with the log odds of its map.
template <typename Value>
std::vector<FitRow> visit_rows_of(const Samples& samples, const std::vector<double>& map_log_odds,
                                  Value value) {
  std::vector<FitRow> rows;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    for (const TrustVisit& visit : samples[i]->visits) {
      rows.push_back({visit.figures, value(visit), i});
      rows.back().figures.push_back({"map", map_log_odds[i]});
    }
  }
  return rows;
}

/// @param known the model that bars are learnt further from, or none
LearntBars bars_of(const Samples& samples, SensorKind sensor,
                   const std::vector<double>& map_log_odds, const LearntModel* known) {
  const auto fitted = [&](const std::vector<FitRow>& rows, LearntSum LearntModel::*sum) {
    const auto from = known != nullptr ? std::optional(known_sum(known->*sum)) : std::nullopt;
    return fit_sum(rows, FitKind::logarithm, from);
  };
  const auto errors = [&](double TrustSample::*error, double least) {
    return rows_of(samples, [&](const TrustSample& one) { return std::max(least, one.*error); });
  };
  const std::vector<FitRow> visits = visit_rows_of(
      samples, map_log_odds,
      [](const TrustVisit& visit) { return std::log(std::max(kLeastPlace_m, visit.place_m)); });
  return {sensor,
          samples.size(),
          visits.size(),
          fitted(errors(&TrustSample::place_m, kLeastPlace_m), &LearntModel::place),
          fitted(errors(&TrustSample::heading_deg, kLeastHeading_deg), &LearntModel::heading),
          fitted(errors(&TrustSample::scale_share, kLeastScale), &LearntModel::scale),
          fitted(visits, &LearntModel::visit_place)};
}

struct Part {
  const char* name;
  const Fitted& fitted;
};

/// Arrays of the parts; what they lost goes to the error stream.
std::string arrays_of(const std::string& prefix, const std::vector<Part>& parts) {
  std::string text;
  for (const Part& part : parts) {
    text += terms_text(prefix + part.name, part.fitted.sum);
    std::fprintf(stderr, "%s%s: penalty %g, loss on what was left out %.4f\n", prefix.c_str(),
                 part.name, part.fitted.penalty, part.fitted.loss);
  }
  return text;
}

/// As the library's struct begins each: the bias and the array's name.
std::string entries_of(const std::string& prefix, const std::vector<Part>& parts) {
  std::string text;
  for (const Part& part : parts) {
    text += ", {" + number_text(part.fitted.sum.bias) + ", " + prefix + part.name + "}";
  }
  return text;
}

std::string prefix_of(SensorKind sensor) {
  return sensor == SensorKind::laser ? "kLaser" : "kSonar";
}

}  // namespace

LearntTrust learn_trust(const std::vector<TrustSample>& samples, SensorKind sensor) {
  const Samples own = of_kind(samples, sensor);
  LearntTrust learnt;
  learnt.right = static_cast<std::size_t>(std::count_if(
      own.begin(), own.end(), [](const TrustSample* sample) { return sample->is_right; }));
  const std::vector<FitRow> right = rows_of(
      own, [](const TrustSample& sample) { return std::clamp(sample.off, kLeastOff, kMostOff); });
  learnt.mission_right = fit_sum(right, FitKind::within_limit);
  std::fputs(given_text(whether_within(right), learnt.mission_right).c_str(), stderr);
  const std::vector<double>& told = learnt.mission_right.left_out;  // as it will be told of others
  learnt.visit_right = fit_sum(
      visit_rows_of(own, told, [](const TrustVisit& visit) { return visit.is_right ? 1.0 : 0.0; }),
      FitKind::log_odds);
  learnt.bars = bars_of(own, sensor, told, nullptr);
  return learnt;
}

LearntBars learn_bars(const std::vector<TrustSample>& samples, SensorKind sensor) {
  const Samples own = of_kind(samples, sensor);
  std::vector<double> told;
  told.reserve(own.size());
  for (const TrustSample* sample : own) {
    const double probability =
        std::clamp(sample->said.probability, kSurest, 1.0 - kSurest);  // 0 and 1 have none
    told.push_back(std::log(probability / (1.0 - probability)));
  }
  return bars_of(own, sensor, told, &model_of(sensor));
}

std::string learnt_source(const LearntTrust& learnt) {
  const LearntBars& bars = learnt.bars;
  const std::string kind = bars.sensor == SensorKind::laser ? "laser" : "sonar";
  const std::string prefix = prefix_of(bars.sensor);
  const std::vector<Part> parts = {
      {"Right", learnt.mission_right},    {"Place", bars.place},
      {"Heading", bars.heading},          {"Scale", bars.scale},
      {"VisitRight", learnt.visit_right}, {"VisitPlace", bars.visit_place}};
  return "// SPDX-License-Identifier: GPL-3.0-or-later\n"
         "// Printed by `bench_trust train " +
         kind + "`, from " + std::to_string(bars.missions) + " missions, " +
         std::to_string(learnt.right) + " of them right, with " + std::to_string(bars.visits) +
         " visits.\n#include \"learnt_model.hpp\"\n\nnamespace roomatlas {\nnamespace {\n\n" +
         arrays_of(prefix, parts) + "}  // namespace\n\nconst LearntModel& " + kind +
         "_model() {\n  static const LearntModel kModel{" +
         number_text(learnt.mission_right.lapses) + entries_of(prefix, parts) +
         "};\n  return kModel;\n}\n\n}  // namespace roomatlas\n";
}

std::string bars_source(const LearntBars& learnt) {
  const std::string prefix = prefix_of(learnt.sensor);
  const std::vector<Part> parts = {{"Place", learnt.place},
                                   {"Heading", learnt.heading},
                                   {"Scale", learnt.scale},
                                   {"VisitPlace", learnt.visit_place}};
  return "// Bars: printed by `bench_trust bars`, from " + std::to_string(learnt.missions) +
         " missions with " + std::to_string(learnt.visits) + " visits.\n" +
         arrays_of(prefix, parts) + entries_of(prefix, parts) + "\n";
}

}  // namespace roomatlas::bench
