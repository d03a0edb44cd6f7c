// SPDX-License-Identifier: GPL-3.0-or-later
#include "learn_trust.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace roomatlas::bench {
namespace {

// Smaller errors are as good as none: logarithms would make much of them.
constexpr double kLeastPlace_m = 0.005;
constexpr double kLeastHeading_deg = 0.05;
constexpr double kLeastScale = 0.0005;
constexpr double kLeastOff = 0.05;
constexpr double kMostOff = 2.7;  // farther ones would matter most, and are told anyway

FitRow row_of(const TrustSample& sample, double target, std::size_t group) {
  return {sample.figures, target, group};
}

}  // namespace

LearntTrust learn_trust(const std::vector<TrustSample>& samples, SensorKind sensor) {
  LearntTrust learnt;
  learnt.sensor = sensor;
  std::vector<FitRow> right, place, heading, scale, visit_right, visit_place;
  std::vector<const TrustSample*> own;
  for (const TrustSample& sample : samples) {
    if (sample.sensor != sensor) continue;
    const std::size_t group = own.size();
    own.push_back(&sample);
    learnt.right += sample.is_right ? 1 : 0;
    right.push_back(row_of(sample, std::log(std::clamp(sample.off, kLeastOff, kMostOff)), group));
    place.push_back(row_of(sample, std::log(std::max(kLeastPlace_m, sample.place_m)), group));
    heading.push_back(
        row_of(sample, std::log(std::max(kLeastHeading_deg, sample.heading_deg)), group));
    scale.push_back(row_of(sample, std::log(std::max(kLeastScale, sample.scale_share)), group));
  }
  learnt.missions = own.size();
  learnt.mission_right = fit_sum(right, FitKind::within_limit);
  std::fputs(given_text(whether_within(right), learnt.mission_right).c_str(), stderr);
  learnt.place = fit_sum(place, FitKind::logarithm);
  learnt.heading = fit_sum(heading, FitKind::logarithm);
  learnt.scale = fit_sum(scale, FitKind::logarithm);
  for (std::size_t i = 0; i < own.size(); ++i) {
    for (const TrustVisit& visit : own[i]->visits) {
      std::vector<JudgedFigure> figures = visit.figures;
      figures.push_back({"map", learnt.mission_right.left_out[i]});  // as it will be told of others
      visit_right.push_back({figures, visit.is_right ? 1.0 : 0.0, i});
      visit_place.push_back({figures, std::log(std::max(kLeastPlace_m, visit.place_m)), i});
    }
  }
  learnt.visits = visit_right.size();
  learnt.visit_right = fit_sum(visit_right, FitKind::log_odds);
  learnt.visit_place = fit_sum(visit_place, FitKind::logarithm);
  return learnt;
}

std::string learnt_source(const LearntTrust& learnt) {
  const bool is_laser = learnt.sensor == SensorKind::laser;
  const std::string kind = is_laser ? "laser" : "sonar";
  const std::string prefix = is_laser ? "kLaser" : "kSonar";
  struct Part {
    const char* name;
    const Fitted& fitted;
  };
  const Part parts[] = {{"Right", learnt.mission_right},    {"Place", learnt.place},
                        {"Heading", learnt.heading},        {"Scale", learnt.scale},
                        {"VisitRight", learnt.visit_right}, {"VisitPlace", learnt.visit_place}};
  std::string text =
      "// SPDX-License-Identifier: GPL-3.0-or-later\n"
      "// Printed by `bench_trust train " +
      kind + "`, from " + std::to_string(learnt.missions) + " missions, " +
      std::to_string(learnt.right) + " of them right, with " + std::to_string(learnt.visits) +
      " visits.\n#include \"learnt_model.hpp\"\n\nnamespace roomatlas {\nnamespace {\n\n";
  for (const Part& part : parts) text += terms_text(prefix + part.name, part.fitted.sum);
  text += "}  // namespace\n\nconst LearntModel& " + kind + "_model() {\n";
  text += "  static const LearntModel kModel{" + number_text(learnt.mission_right.lapses);
  for (const Part& part : parts) {
    text += ", {" + number_text(part.fitted.sum.bias) + ", " + prefix + part.name + "}";
  }
  text += "};\n  return kModel;\n}\n\n}  // namespace roomatlas\n";
  for (const Part& part : parts) {
    std::fprintf(stderr, "%s %s: penalty %g, loss on what was left out %.4f\n", kind.c_str(),
                 part.name, part.fitted.penalty, part.fitted.loss);
  }
  return text;
}

}  // namespace roomatlas::bench
