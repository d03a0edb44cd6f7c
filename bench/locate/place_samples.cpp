// SPDX-License-Identifier: GPL-3.0-or-later
#include "place_samples.hpp"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "trust/fit_sum.hpp"

namespace roomatlas::bench {
namespace {

using Json = nlohmann::ordered_json;

PlaceSample sample_of(const Json& one) {
  PlaceSample sample;
  sample.asked = one.at("asked").get<std::string>();
  sample.sensor = one.at("sensor") == "laser" ? SensorKind::laser : SensorKind::sonar;
  sample.is_known = one.at("known").get<bool>();
  sample.is_right = one.at("right").get<bool>();
  sample.probability = one.at("probability").get<double>();
  for (const auto& [name, value] : one.at("figures").items()) {
    sample.figures.push_back({name, value.get<double>()});
  }
  return sample;
}

/// What something is learnt from. Of a laser's rays many can contradict: their odds say it better;
/// which of them nobody is told of says what its walls do.
std::vector<JudgedFigure> told_by(const PlaceSample& sample) {
  std::vector<JudgedFigure> figures = sample.figures;
  const std::string left_out = sample.sensor == SensorKind::laser ? "rays" : "contradicting rays";
  std::erase_if(figures, [&](const JudgedFigure& one) { return one.name.starts_with(left_out); });
  return figures;
}

}  // namespace

std::string line_of(const PlaceSample& sample) {
  Json figures = Json::object();
  for (const JudgedFigure& figure : sample.figures) figures[figure.name] = figure.value;
  const Json one = {{"asked", sample.asked},
                    {"sensor", sample.sensor == SensorKind::laser ? "laser" : "sonar"},
                    {"known", sample.is_known},
                    {"right", sample.is_right},
                    {"probability", sample.probability},
                    {"figures", figures}};
  return one.dump();
}

std::vector<PlaceSample> read_place_samples(const std::vector<std::filesystem::path>& files) {
  std::vector<PlaceSample> samples;
  for (const std::filesystem::path& file : files) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error(file.string() + ": cannot be read");
    for (std::string line; std::getline(in, line);) {
      samples.push_back(sample_of(Json::parse(line)));
    }
  }
  return samples;
}

std::string learnt_places(const std::vector<PlaceSample>& samples, SensorKind sensor) {
  std::vector<FitRow> rows;
  std::map<std::string, std::size_t> groups;
  std::size_t right = 0;
  for (const PlaceSample& sample : samples) {
    if (sample.sensor != sensor || sample.figures.empty()) continue;
    const std::size_t group = groups.emplace(sample.asked, groups.size()).first->second;
    rows.push_back({told_by(sample), sample.is_right ? 1.0 : 0.0, group});
    right += sample.is_right ? 1 : 0;
  }
  if (rows.empty()) throw std::runtime_error("no samples of this kind of sensor");
  const Fitted fitted = fit_sum(rows, FitKind::log_odds);
  const std::string kind = sensor == SensorKind::laser ? "laser" : "sonar";
  std::fprintf(stderr, "%s: penalty %g, loss on pairs that were left out %.4f; there\n",
               kind.c_str(), fitted.penalty, fitted.loss);
  std::fputs(given_text(rows, fitted).c_str(), stderr);
  return "// SPDX-License-Identifier: GPL-3.0-or-later\n// Printed by `bench_locate train " + kind +
         "`, from " + std::to_string(rows.size()) + " queries of " + std::to_string(groups.size()) +
         " pairs, " + std::to_string(right) +
         " of them right.\n#include \"learnt_places.hpp\"\n\nnamespace roomatlas {\n\n"
         "const LearntSum& " +
         kind + "_place_is_right() {\n" + terms_text("kTerms", fitted.sum) +
         "  static const LearntSum kSum{" + number_text(fitted.sum.bias) +
         ", kTerms};\n  return kSum;\n}\n\n}  // namespace roomatlas\n";
}

}  // namespace roomatlas::bench
